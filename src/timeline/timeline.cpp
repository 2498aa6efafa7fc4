#include "timeline/timeline.h"

#include "math/overloaded.h"
#include "trace/photon_pass.h"

#include <algorithm>
#include <numeric>

namespace raywalk {

/// Reads the events once, in order, and tracks the current state.
Timeline::Timeline(std::vector<Event> events, ImageSize image) : image_(image), events_(std::move(events)) {
  moments_.reserve(events_.size() + 1);
  std::vector<int> record_of_ray;  // the recording's ray number -> index in rays_, which also holds stubs
  int innermost = -1;              // the current SHADE
  int pixel = -1;
  int on_path = -1;           // the current ray of FOLLOW PATH
  std::vector<int> parts;     // of each SHADE PARTS, the current one
  Vec3d next_direction{0.0};  // the one that FOLLOW PATH has chosen
  Rgbd next_throughput{0.0};

  for (std::size_t i = 0; i < events_.size(); ++i) {
    const Event& event = events_[i];
    const int after = static_cast<int>(i) + 1;
    const int executing = innermost;
    int ray = executing >= 0 ? frames_[static_cast<std::size_t>(executing)].ray : moments_.back().ray;
    if (on_path >= 0) ray = on_path;
    parts.resize(frames_.size(), -1);
    if (executing >= 0 && parts[static_cast<std::size_t>(executing)] >= 0)
      ray = parts[static_cast<std::size_t>(executing)];

    const auto add_ray = [&](RayRecord record) {
      record.pixel = std::max(pixel, 0);  // photons, which no pixel has sent, count as the first one's
      record.depth = event.depth;
      record.frame = executing;
      record.formed_at = after;
      ray = static_cast<int>(rays_.size());
      rays_.push_back(record);
    };
    const auto name_ray = [&](int number) {
      record_of_ray.resize(std::max(record_of_ray.size(), static_cast<std::size_t>(number) + 1), -1);
      record_of_ray[static_cast<std::size_t>(number)] = ray;
    };
    const auto end_path = [&] {
      frames_[static_cast<std::size_t>(innermost)].returned_at = after;
      innermost = -1;
      on_path = -1;
    };
    const auto index_of = [&](int number) { return record_of_ray[static_cast<std::size_t>(number)]; };
    const auto parent_of = [&](int number) { return number < 0 ? -1 : index_of(number); };

    std::visit(
        Overloaded{
            [&](const PixelBegun& begun) {
              pixel = static_cast<int>(pixels_.size());
              pixels_.push_back({begun.column, begun.row, begun.sample, after, after});
              ray = -1;
            },
            [&](const RayFormed& formed) {
              RayRecord record;
              record.kind = formed.kind;
              record.parent = parent_of(formed.parent);
              record.origin = formed.origin;
              record.direction = formed.direction;
              record.endless = !formed.light_at_end;
              record.end = formed.origin + (record.endless ? normalize(formed.direction) : formed.direction);
              record.light = formed.light;
              record.radius = formed.radius, record.end_radius = formed.end_radius;
              record.throughput = formed.throughput;
              record.found_at = static_cast<int>(events_.size()) + 1;
              add_ray(record);
              name_ray(formed.ray);
              if (event.line == Line::form_next_ray || event.line == Line::photon_form_next_ray ||
                  event.line == Line::gather_form_next_ray)
                on_path = ray;
            },
            [&](const RayNotFormed& stub) {
              RayRecord record;
              record.formed = false;
              record.kind = stub.kind;
              record.ending = stub.why;
              record.parent = parent_of(stub.parent);
              record.origin = stub.origin;
              record.direction = stub.direction;
              const double size = length(stub.direction);
              record.end = size > 0 ? stub.origin + stub.direction / size : stub.origin;
              record.light = stub.light;
              record.throughput = stub.throughput;
              record.found_at = after;
              add_ray(record);
            },
            [&](const Found& found) {
              ray = index_of(found.ray);
              RayRecord& record = rays_[static_cast<std::size_t>(ray)];
              record.ending = found.ending;
              record.found_at = after;
              record.transmittance = found.transmittance;
              record.object = found.object;
              record.part = found.part;
              if (found.object >= 0) {
                record.end = found.point;
                record.normal = found.normal;
                record.shaded = found.shaded;
                record.endless = false;
              }
            },
            [&](const Decided& decided) {
              if (event.line == Line::follow_path || event.line == Line::follow_photon ||
                  event.line == Line::gather_light) {
                on_path = moments_.back().ray;
                ray = on_path;
                innermost = static_cast<int>(frames_.size());
                frames_.push_back({-1, 1, ray, after, after, Rgbd(0.0)});
                rays_[static_cast<std::size_t>(ray)].shade = innermost;
              }
              const bool loops = event.line == Line::while_ray || event.line == Line::while_photon ||
                                 event.line == Line::gather_while_ray;
              if (loops && !decided.holds) end_path();
              if (decided.why != Ending::total_internal_reflection) return;
              // The nonexistent refract ray would at best graze the surface: shown as a stub along it.
              const RayRecord parent = rays_[static_cast<std::size_t>(ray)];
              RayRecord record;
              record.formed = false;
              record.kind = RayKind::refract;
              record.ending = Ending::total_internal_reflection;
              record.parent = ray;
              record.origin = parent.end;
              const Vec3d& normal = parent.shaded.shading;
              const Vec3d along = parent.direction - dot(parent.direction, normal) * normal;
              const double size = length(along);
              record.direction = size > 0 ? along / size : parent.direction;
              record.end = record.origin + record.direction;
              record.throughput = Rgbd(0.0);
              record.found_at = after;
              add_ray(record);
            },
            [&](const ShadeCalled& called) {
              ray = index_of(called.ray);
              if (called.missed) return;
              const int frame = static_cast<int>(frames_.size());
              frames_.push_back({innermost, called.depth, ray, after, after, Rgbd(0.0)});
              rays_[static_cast<std::size_t>(ray)].shade = frame;
              innermost = frame;
            },
            [&](const ShadeComputed& computed) {
              FrameRecord& frame = frames_[static_cast<std::size_t>(innermost)];
              frame.returned = computed.total;
              frame.returned_at = after;
              innermost = frame.parent;
            },
            [&](const BackgroundAdded& background) {
              frames_[static_cast<std::size_t>(innermost)].returned += background.added;
              end_path();
            },
            [&](const EmissionAdded& emission) {
              frames_[static_cast<std::size_t>(innermost)].returned += emission.added;
            },
            [&](const LightAdded& light) { frames_[static_cast<std::size_t>(innermost)].returned += light.added; },
            [&](const DirectionChosen& chosen) {
              next_direction = chosen.direction;
              next_throughput = chosen.throughput;
            },
            [&](const SurvivalDecided& decided) {
              if (decided.why != Ending::threshold) return;
              // Where Russian roulette ended the path: a stub of the ray that would have followed.
              RayRecord record;
              record.formed = false;
              record.kind = event.line == Line::if_photon_survives ? RayKind::photon : RayKind::reflect;
              record.ending = Ending::threshold;
              record.parent = on_path;
              record.origin = rays_[static_cast<std::size_t>(on_path)].end;
              record.direction = next_direction;
              record.end = record.origin + record.direction;
              record.throughput = next_throughput;
              record.found_at = after;
              add_ray(record);
            },
            [&](const PhotonBegun&) {
              ray = -1;
              all_photons_at_ = after;
            },
            [&](const PhotonStored& stored) {
              stored_photons_.push_back(
                  {stored.position, stored.normal, stored.power, stored.history, stored.kept, after});
            },
            [&](const PhotonsFound&) {},
            [&](const PatchesMade& made) {
              ray = -1;
              if (made.lights) lights_known_.push_back(after);
            },
            [&](const UnshotLight&) { ray = -1; },
            [&](const PatchTaken&) { ray = -1; },
            [&](const PatchShot& shot) {
              ray = -1;
              if (!shot.lights) return;
              lights_known_.push_back(after);
              shot_ends_.push_back(after);
            },
            [&](const PatchInFront&) { ray = -1; },
            [&](const FormFactorFound&) { ray = -1; },
            [&](const LightArrived&) { ray = -1; },
            [&](const PatchEmptied&) {
              ray = -1;
              shot_ends_.push_back(after);
            },
            [&](const LightLookedUp&) {},
            [&](const PhotonsAdded& photons) {
              frames_[static_cast<std::size_t>(innermost)].returned += photons.added;
            },
            [&](const BeamFormed& formed) {
              RayRecord record;
              record.kind = RayKind::beam;
              record.parent = parent_of(formed.parent);
              record.origin = formed.area.starts.front();
              record.end = formed.area.ends.front();
              if (!is_flat() || of_cones()) {  // along its axis
                record.origin = (record.origin + formed.area.starts.back()) / 2.0;
                record.end = (record.end + formed.area.ends.back()) / 2.0;
              }
              record.direction = normalize(record.end - record.origin);
              record.endless = true;
              record.throughput = formed.throughput;
              record.found_at = static_cast<int>(events_.size()) + 1;
              record.beam = static_cast<int>(beams_.size());
              beams_.push_back({formed.area, formed.begin, formed.end, formed.end - formed.begin});
              add_ray(record);
              name_ray(formed.ray);
            },
            [&](const BeamCut& cut) {
              const int whole = index_of(cut.ray);
              rays_[static_cast<std::size_t>(whole)].found_at = after;
              rays_[static_cast<std::size_t>(whole)].ending = Ending::hit;
              BeamRecord& beam = beams_[static_cast<std::size_t>(rays_[static_cast<std::size_t>(whole)].beam)];
              beam.parts = static_cast<int>(cut.pieces.size());
              const double width = beam.end - beam.begin;
              for (const BeamPiece& piece : cut.pieces) {
                RayRecord record;
                record.kind = RayKind::beam;
                record.ending = piece.object < 0 ? Ending::missed : Ending::hit;
                record.parent = whole;
                record.origin = piece.origin;
                record.end = piece.point;
                record.direction = normalize(piece.point - piece.origin);
                record.endless = piece.object < 0;
                record.normal = piece.normal;
                record.shaded = piece.shaded;
                record.object = piece.object;
                record.throughput = rays_[static_cast<std::size_t>(whole)].throughput * (piece.coverage / width);
                record.found_at = after;
                record.beam = static_cast<int>(beams_.size());
                const int never = static_cast<int>(events_.size()) + 1;
                beams_.push_back({piece.area, piece.begin, piece.end, piece.coverage, 0, never, never});
                add_ray(record);
                name_ray(piece.ray);
              }
              ray = whole;
            },
            [&](const PartBegun& begun) {
              ray = index_of(begun.ray);
              parts[static_cast<std::size_t>(innermost)] = ray;
              beams_[static_cast<std::size_t>(rays_[static_cast<std::size_t>(ray)].beam)].begun_at = after;
            },
            [&](const PartShaded&) {},
            [&](const PencilChanged& changed) { ray = index_of(changed.ray); },
            [&](const PartAdded& added) {
              ray = index_of(added.ray);
              BeamRecord& part = beams_[static_cast<std::size_t>(rays_[static_cast<std::size_t>(ray)].beam)];
              part.added_at = after;
              part.shade = added.shade;
              FrameRecord& frame = frames_[static_cast<std::size_t>(innermost)];
              frame.returned = added.mean;
              if (!added.last) return;
              frame.returned_at = after;
              innermost = frame.parent;
            },
            [&](const PixelPut& put) {
              pixels_.back().shade = put.shade;
              pixels_.back().mean = put.shade;
              // Accumulated as in the film; the samples of a pixel are recorded one after the other.
              if (pixels_.size() > 1 && put.sample > 0) {
                const PixelRecord& before = pixels_[pixels_.size() - 2];
                if (before.column == put.column && before.row == put.row)
                  pixels_.back().mean = before.mean + (put.shade - before.mean) / static_cast<double>(put.sample + 1);
              }
              pixels_.back().done_at = after;
            },
        },
        event.detail);
    moments_.push_back({static_cast<int>(rays_.size()), ray, executing, innermost, pixel});
  }
}

int Timeline::part_of(int ray) const {
  while (ray >= 0) {
    const RayRecord& record = rays_[static_cast<std::size_t>(ray)];
    if (record.beam >= 0 && beams_[static_cast<std::size_t>(record.beam)].parts == 0 && record.parent >= 0) return ray;
    ray = record.parent;
  }
  return -1;
}

double Timeline::steps_of_all_rays() const {
  const auto rays = std::accumulate(statistics_.rays.begin(), statistics_.rays.end(), std::uint64_t{0});
  return std::max<double>(steps(), 2 * static_cast<double>(rays));
}

const PhotonMaps* Timeline::photons() const {
  return photon_maps_ && !photon_maps_->empty() ? photon_maps_->data() : nullptr;
}

std::vector<PatchLight> Timeline::lights_at(int position) const {
  const auto known = std::upper_bound(lights_known_.begin(), lights_known_.end(), position);
  if (known == lights_known_.begin()) return {};
  const int from = *std::prev(known);
  const EventDetail& last = event(from - 1).detail;
  const auto* made = std::get_if<PatchesMade>(&last);
  std::vector<PatchLight> lights = made != nullptr ? *made->lights : *std::get<PatchShot>(last).lights;
  for (int i = from; i < position; ++i) {
    const auto set = [&](int patch, const PatchLight& light) { lights[static_cast<std::size_t>(patch)] = light; };
    if (const auto* arrived = std::get_if<LightArrived>(&event(i).detail)) set(arrived->patch, arrived->light);
    if (const auto* emptied = std::get_if<PatchEmptied>(&event(i).detail)) set(emptied->patch, emptied->light);
  }
  return lights;
}

double Timeline::unshot_at(int position) const {
  const auto end = std::upper_bound(shot_ends_.begin(), shot_ends_.end(), position);
  if (end == shot_ends_.begin()) return 1;
  const EventDetail& last = event(*std::prev(end) - 1).detail;
  const auto* emptied = std::get_if<PatchEmptied>(&last);
  return emptied != nullptr ? emptied->share : std::get<PatchShot>(last).share;
}

int Timeline::end_of_shot(int position) const {
  const auto end = std::upper_bound(shot_ends_.begin(), shot_ends_.end(), position);
  return end == shot_ends_.end() ? -1 : *end;
}

const Event* Timeline::just_run(int position) const { return position > 0 ? &event(position - 1) : nullptr; }

const Event* Timeline::next(int position) const { return position < steps() ? &event(position) : nullptr; }

std::span<const RayRecord> Timeline::rays_at(int position) const {
  return std::span(rays_).first(static_cast<std::size_t>(moment(position).rays));
}

int Timeline::current_ray(int position) const { return moment(position).ray; }

int Timeline::current_frame(int position) const { return moment(position).frame; }

int Timeline::current_pixel(int position) const { return moment(position).pixel; }

std::vector<int> Timeline::stack(int position) const {
  std::vector<int> calls;
  for (int frame = moment(position).innermost; frame >= 0; frame = frames_[static_cast<std::size_t>(frame)].parent)
    calls.push_back(frame);
  return calls;
}

bool Timeline::pixel_done(int pixel, int position) const {
  return pixels_[static_cast<std::size_t>(pixel)].done_at <= position;
}

Timeline::Range Timeline::rays_of_pixel(int pixel) const {
  const PixelRecord& record = pixels_[static_cast<std::size_t>(pixel)];
  return {moment(record.begun_at).rays, moment(record.done_at).rays};
}

int Timeline::next_ray(int position) const {
  const auto formed = static_cast<std::size_t>(moment(position).rays);
  return formed < rays_.size() ? rays_[formed].formed_at : steps();
}

int Timeline::previous_ray(int position) const {
  // The last ray formed strictly before this position's own.
  const auto before = std::lower_bound(rays_.begin(), rays_.end(), position,
                                       [](const RayRecord& ray, int p) { return ray.formed_at < p; });
  return before == rays_.begin() ? 0 : std::prev(before)->formed_at;
}

int Timeline::next_pixel(int position) const {
  if (const int shot = end_of_shot(position); shot >= 0) return shot;
  const auto next = std::upper_bound(pixels_.begin(), pixels_.end(), position,
                                     [](int p, const PixelRecord& pixel) { return p < pixel.done_at; });
  return next == pixels_.end() ? steps() : next->done_at;
}

int Timeline::previous_pixel(int position) const {
  const auto shot = std::lower_bound(shot_ends_.begin(), shot_ends_.end(), position);
  const auto before = std::lower_bound(pixels_.begin(), pixels_.end(), position,
                                       [](const PixelRecord& pixel, int p) { return pixel.done_at < p; });
  if (before != pixels_.begin()) return std::prev(before)->done_at;
  return shot == shot_ends_.begin() ? 0 : *std::prev(shot);
}

}  // namespace raywalk
