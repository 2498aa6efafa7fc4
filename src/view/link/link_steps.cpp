// What links hold of a state, and how one is opened.

#include "io/scene_patch.h"
#include "view/action.h"
#include "view/document/document.h"
#include "view/link/link.h"
#include "view/text/text.h"
#include "view/walk/walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

namespace raywalk {

namespace {

namespace fs = std::filesystem;

/// How links begin where there is no page that they could lead to.
constexpr std::string_view own_scheme = "raywalk:";
/// More than fits into any link; comparing them would only take time.
constexpr std::size_t most_objects = 1000, most_triangles = 1000;

bool may_fit(const Scene& scene) {
  std::size_t objects = scene.objects.size() + scene.lights.size(), triangles = 0;
  const auto count = [&](const std::vector<Object>& of) {
    for (const Object& object : of)
      if (const auto* mesh = std::get_if<MeshShape>(&object.shape); mesh != nullptr && mesh->mesh && mesh->file.empty())
        triangles += mesh->mesh->triangles.size();
  };
  count(scene.objects);
  for (const Group& group : scene.groups) {
    objects += group.objects.size();
    count(group.objects);
  }
  return objects <= most_objects && triangles <= most_triangles;
}

tl::unexpected<Error> no_link(const State& state, std::string_view why) {
  return tl::unexpected(Error{"", 0, 0, std::string(text(why, state.appearance.language)), ""});
}

/// Of these a page takes some seconds, in which it answers nobody.
constexpr int most_photons = 1'000'000;

/// `base` with a link's changes, which may not ask for endless work.
Result<SceneDocument> patched_by_link(const SceneDocument& base, std::string_view changes) {
  auto patched = patched_scene(base, changes);
  if (!patched) return patched;
  const int photons = patched->scene.render.photons.count;
  if (photons > std::max(most_photons, base.scene.render.photons.count))
    return tl::unexpected(
        Error{"", 0, 0, fmt::format("it sends {} photons (expected at most {} in a link)", photons, most_photons), ""});
  return patched;
}

/// What `scene`, whose files are named from `path`, has changed of `base`. Fails if these changes do not lead back to
/// it.
Result<std::string> changes_of(const SceneDocument& base, const Scene& scene, const std::string& path) {
  auto renamed = with_names_from(scene, path, base.path);
  if (!renamed) return tl::unexpected(renamed.error());
  std::string changes = scene_patch(base.scene, *renamed);
  const auto again = patched_by_link(base, changes);
  if (!again) return tl::unexpected(again.error());
  if (again->scene != *renamed) return tl::unexpected(Error{"", 0, 0, "it cannot be told in a link without loss", ""});
  return changes;
}

/// The shipped scene from which a link's scene begins, and what is changed of it.
struct Beginning {
  std::string name;  ///< empty: none
  SceneDocument scene;
  std::string changes;
};

/// The one that leaves least to change.
Result<Beginning> beginning_of(const State& state) {
  const Scene& scene = state.scene();
  const std::string& path = state.document.contents.path;
  std::vector<std::string> names = shipped_names(state);
  // What was opened from there begins there, even if something else is now as near.
  const std::string own = fs::path(path).stem().string();
  if (std::find(names.begin(), names.end(), own) != names.end() && fs::path(path) == fs::path(shipped_path(state, own)))
    names = {own};
  else
    names.push_back({});
  std::optional<Beginning> best;
  std::optional<Error> why_not;
  for (const std::string& name : names) {
    auto base = name.empty() ? Result<SceneDocument>(SceneDocument{}) : read_scene(shipped_path(state, name));
    if (!base) continue;
    auto changes = changes_of(*base, scene, path);
    if (!changes) why_not = changes.error();
    if (changes && (!best || changes->size() < best->changes.size()))
      best = Beginning{name, std::move(*base), std::move(*changes)};
  }
  if (best) return std::move(*best);
  return tl::unexpected(why_not.value_or(Error{}));
}

/// The scene's part of a link; the rest of it is added.
Result<Link> scene_link(const State& state) {
  Link link;
  if (state.bugs.hunt) {
    link.bug = state.bugs.hunt->number;
    return link;
  }
  if (!may_fit(state.scene())) return no_link(state, "link.too_large");
  const auto refuse = [&](const Error& why) {
    return tl::unexpected(
        Error{"", 0, 0, fill("link.cannot_hold", state.appearance.language, {{"why", why.message}}), ""});
  };
  const SceneDocument* base = nullptr;
  std::optional<Beginning> beginning;
  if (const PlayedStep* at = state.lessons.at()) {
    link.lesson = state.lessons.open->lesson.name;
    link.lesson_step = state.lessons.step + 1;
    base = &at->walk->document;
    auto changes = changes_of(*base, state.scene(), state.document.contents.path);
    if (!changes) return refuse(changes.error());
    link.changes = std::move(*changes);
  } else {
    auto found = beginning_of(state);
    if (!found) return refuse(found.error());
    beginning = std::move(*found);
    link.scene = beginning->name;
    link.changes = beginning->changes;
    base = &beginning->scene;
  }
  if (!link.changes.empty() || !link.tells_scene()) link.sum = scene_sum(base->scene);
  return link;
}

/// Its own words, where it says them in the language of the window.
void refuse_link(State& state, const Error& why) {
  complain(state, fill("link.refused", state.appearance.language, {{"why", why.message}}));
}

void set_walk(State& state, const Link& link) {
  ImageSettings settings = state.picture.settings;
  settings.integrator = link.integrator;
  settings.single_precision = link.single_precision;
  settings.walk_samples = link.walk_samples;
  action::SetImageSettings{settings}.apply(state);
  if (link.left_out.any() || link.depth) EffectsRoom::leave_out(state, link.left_out, link.depth);
  if (!link.camera.empty())
    if (const auto seen = patched_scene(state.document.contents, link.camera)) {
      state.picture.camera = seen->scene.camera;
      ++state.picture.revision;
    }
  std::optional<PixelWalk> walked = state.walk.pixel;
  if (walked) walked->camera.reset();
  if (walked == link.pixel) return;  // a lesson's, which may lie on the strip
  if (!link.pixel) return action::WalkStrip{}.apply(state);
  action::WalkPixel{link.pixel->column, link.pixel->row, link.pixel->size}.apply(state);
}

void set_moment(State& state, const Link& link) {
  if (link.step) action::Jump{*link.step}.apply(state);
  if (link.tab) action::SetTab{*link.tab}.apply(state);
  if (link.mode && *link.mode != state.walk.mode) action::SetMode{*link.mode}.apply(state);
  if (link.theme) action::SetTheme{*link.theme}.apply(state);
}

/// `base` with a link's changes; fails if its camera cannot see the outcome either.
Result<SceneDocument> changed_by(const Link& link, const SceneDocument& base) {
  auto changed = patched_by_link(base, link.changes);
  if (!changed) return changed;
  if (const auto seen = patched_scene(*changed, link.camera); !seen) return tl::unexpected(seen.error());
  return changed;
}

/// Opens the scene that it tells; a sentence about it, or why not.
Result<std::string> open_scene_of(State& state, const Link& link) {
  const Language language = state.appearance.language;
  if (link.bug > 0) {
    action::ShowBugs{true}.apply(state);
    action::HuntBug{link.bug}.apply(state);
    return std::string();
  }
  const auto no_lesson = [&] {
    return tl::unexpected(Error{"", 0, 0, fill("lesson.unknown", language, {{"name", link.lesson}}), ""});
  };
  std::uint32_t sum = 0;
  std::string name;
  if (!link.lesson.empty()) {
    action::ShowLessons{true}.apply(state);
    if (state.lessons.entry(link.lesson) == nullptr) return no_lesson();
    if (!open_lesson(state, link.lesson, link.lesson_step - 1)) return no_lesson();
    const PlayedStep* at = state.lessons.at();
    sum = scene_sum(at->walk->document.scene);
    auto changed = changed_by(link, at->walk->document);
    if (!changed) return tl::unexpected(changed.error());
    if (!link.changes.empty()) commit(state, std::move(changed->scene));
    name = state.lessons.open->lesson.told(language).title;
  } else if (link.tells_scene()) {
    auto linked = linked_scene(link, shipped_path(state, link.scene));
    if (!linked) return tl::unexpected(linked.error());
    sum = linked->sum;
    const std::string path = link.changes.empty() ? linked->document.path : std::string();
    name = linked->document.scene.title.empty() ? link.scene : linked->document.scene.title;
    show_another(state, std::move(linked->document), path);
    if (state.lessons.shown) action::ShowLessons{false}.apply(state);
  }
  if (link.sum && *link.sum != sum) return fill("link.other_version", language, {{"scene", name}});
  // A lesson stands there with its title, and a notice would hide what it asks about.
  return name.empty() || !link.lesson.empty() ? std::string() : fill("notice.opened", language, {{"file", name}});
}

/// Opens it, once unsaved work is settled.
void open_link(State& state, const std::string& address) {
  const auto link = read_link(address);
  if (!link) return refuse_link(state, link.error());
  if (const auto language = state.appearance.language.others().find(link->language))
    state.appearance.language = *language;
  const auto opened = open_scene_of(state, *link);
  if (!opened) return refuse_link(state, opened.error());
  set_walk(state, *link);
  set_moment(state, *link);
  if (!link->lesson.empty()) state.appearance.front = Front::lesson;  // where the tabs would hide what it asks
  if (!opened->empty()) inform_above(state, *opened);
}

bool has_complaint(const State& state) {
  return state.document.notice && state.document.notice->kind == Notice::Kind::error;
}

void show_link(State& state) {
  LinkRoom& room = state.link;
  const auto link = link_of(state);
  room.letters = link ? write_link(*link) : std::string();
  room.why_not = link ? std::string() : link.error().message;
  if (room.letters.size() > max_link) {
    room.letters.clear();
    room.why_not = text("link.too_large", state.appearance.language);
  }
  room.shown = true;
}

}  // namespace

const std::string& page_of_links(const State& state) {
  return state.link.page.empty() ? state.link.own_page : state.link.page;
}

std::string address_shown(const State& state) {
  if (state.link.letters.empty()) return {};
  const std::string& page = page_of_links(state);
  return (page.empty() ? std::string(own_scheme) : page) + state.link.letters;
}

Result<LinkedScene> linked_scene(const Link& link, const std::string& shipped) {
  auto base = link.scene.empty() ? Result<SceneDocument>(SceneDocument{}) : read_scene(shipped);
  if (!base)
    return tl::unexpected(Error{"", 0, 0, fmt::format("its scene {}: {}", link.scene, base.error().message),
                                "a later version may have it"});
  auto changed = changed_by(link, *base);
  if (!changed) return tl::unexpected(changed.error());
  return LinkedScene{std::move(*changed), scene_sum(base->scene)};
}

Result<Link> link_of(const State& state) {
  auto link = scene_link(state);
  if (!link) return link;
  const std::optional<Camera>& camera = state.walk.pixel ? state.walk.pixel->camera : state.picture.camera;
  if (camera) {
    Scene seen = state.scene();
    seen.camera = *camera;
    link->camera = scene_patch(state.scene(), seen);
  }
  if (state.walk.pixel) {
    link->pixel = *state.walk.pixel;
    link->pixel->camera.reset();
  }
  const ImageSettings& settings = state.picture.settings;
  link->integrator = settings.integrator;
  link->single_precision = settings.single_precision;
  link->walk_samples = settings.walk_samples;
  link->left_out = state.effects.left_out;
  if (state.effects.depth != state.scene().limits.depth) link->depth = state.effects.depth;
  link->step = state.walk.position;
  link->mode = state.walk.mode == Mode::help ? state.walk.before_help : state.walk.mode;
  link->tab = state.appearance.tab;
  link->language = state.appearance.language.code();
  link->theme = state.appearance.theme;
  return link;
}

void action::CopyLink::apply(State& state) const {
  show_link(state);
  LinkRoom& room = state.link;
  if (room.letters.empty()) return;  // the reason is shown
  room.shown = false;
  room.copied = address_shown(state);
  ++room.copies;
  inform(state, fill("link.copied", state.appearance.language, {{"letters", room.copied.size()}}));
}

void action::ShowLink::apply(State& state) const {
  if (shown) return show_link(state);
  state.link.shown = false;
}

void action::SetLinkPage::apply(State& state) const {
  // An address that leads anywhere, without what belongs to the link.
  state.link.page = address.substr(0, address.find('#'));
}

void action::OpenLink::apply(State& state) const {
  const auto read = read_link(link);
  if (!read) return refuse_link(state, read.error());
  const PathPrompt prompt = std::exchange(state.document.prompt, PathPrompt::none);
  const bool asked = prompt == PathPrompt::open || prompt == PathPrompt::start;
  if (asked && has_complaint(state)) state.document.notice.reset();  // about what was tried before
  state.document.after_save.reset();
  if (read->bug > 0)  // a hunt keeps the scene until its end
    open_link(state, link);
  else
    ask_or_do(state, {state.lessons.open ? "question.unsaved_lesson_link" : "question.unsaved_link", open_link}, link);
  // If it cannot be opened, the dialog stays and says why.
  if (asked && !state.document.question && has_complaint(state)) state.document.prompt = prompt;
}

}  // namespace raywalk
