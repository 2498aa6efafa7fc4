#include "gui/gallery.h"

#include "gui/broken_lines.h"
#include "gui/widgets.h"
#include "gui/window.h"
#include "image/image_file.h"
#include "io/scene_file.h"
#include "view/document/document.h"
#include "view/lesson/lesson_panel.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace raywalk {

struct GalleryPictures::Kept {
  Texture texture;
  Picture shown;
};

GalleryPictures::GalleryPictures() = default;
GalleryPictures::~GalleryPictures() = default;

GalleryPictures::Picture GalleryPictures::of(const std::string& path) {
  if (path.empty()) return {};
  std::unique_ptr<Kept>& kept = kept_[path];
  if (kept == nullptr) {
    kept = std::make_unique<Kept>();
    if (const Result<Image> image = read_image(path)) {
      const std::vector<std::uint8_t> rgb = bytes_of(*image, Encoding::srgb);
      std::vector<std::uint8_t> rgba(rgb.size() / 3 * 4, 255);
      for (std::size_t i = 0; i < rgb.size() / 3; ++i)
        std::copy_n(rgb.begin() + 3 * static_cast<std::ptrdiff_t>(i), 3,
                    rgba.begin() + 4 * static_cast<std::ptrdiff_t>(i));
      kept->texture.upload(image->width, image->height, rgba.data());
      kept->shown = {kept->texture.id(), static_cast<float>(image->width), static_cast<float>(image->height)};
    }
  }
  return kept->shown;
}

void GalleryPictures::forget() { kept_.clear(); }

namespace {

namespace fs = std::filesystem;

std::string picture_of(const std::string& folder, const std::string& scene) {
  return scene.empty() ? std::string() : (fs::path(folder) / "pictures" / (scene + ".png")).string();
}

// Of a shipped scene in the window's language, else what its file says.
std::string sentence_of(const State& state, const std::string& scene, const std::string& path) {
  if (const std::string* known = shipped_sentence(state, scene)) return *known;
  const Result<SceneDocument> document = read_scene(path);
  return !document                             ? std::string()
         : document->scene.description.empty() ? document->scene.title
                                               : document->scene.description;
}

// As dictionaries do: neither capitals nor accents count.
std::string sorted_by(const std::string& title) {
  constexpr std::string_view plain = "aaaaaaaceeeeiiiidnooooo-ouuuuyts";  // of U+00C0 and on, and of U+00E0 and on
  std::string key;
  for (std::size_t i = 0; i < title.size(); ++i) {
    const auto byte = static_cast<unsigned char>(title[i]);
    if (byte == 0xC3 && i + 1 < title.size())
      key += plain[static_cast<unsigned char>(title[++i]) & 0x1Fu];
    else
      key += byte >= 'A' && byte <= 'Z' ? static_cast<char>(byte + ('a' - 'A')) : title[i];
  }
  return key;
}

}  // namespace

std::vector<GalleryCard> scene_cards(const State& state) {
  const auto say = [&](std::string_view id) { return fill(id, state.appearance.language); };
  std::vector<GalleryCard> cards{{"scene-new", say("scene.new_title"), say("files.new_scene"), {}, {}, {}, false}};
  for (const std::string& scene : shipped_names(state)) {
    const std::string path = shipped_path(state, scene);
    cards.push_back({"scene/" + scene,
                     shipped_title(state, scene),
                     sentence_of(state, scene, path),
                     picture_of(state.lessons.scenes_folder, scene),
                     path,
                     {},
                     false});
  }
  std::sort(cards.begin() + 1, cards.end(),
            [](const GalleryCard& a, const GalleryCard& b) { return sorted_by(a.title) < sorted_by(b.title); });
  // The classic scene is where everybody begins.
  const auto classic =
      std::find_if(cards.begin(), cards.end(), [](const GalleryCard& card) { return card.name == "scene/classic"; });
  if (classic != cards.end()) std::rotate(cards.begin() + 1, classic, classic + 1);
  return cards;
}

std::vector<GalleryCard> lesson_cards(const State& state) {
  const Language language = state.appearance.language;
  const std::vector<LessonRow> rows = lesson_rows(state.lessons, language);
  std::vector<GalleryCard> cards;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const LessonEntry& entry = state.lessons.list[i];
    cards.push_back({"lesson-card/" + entry.name,
                     std::to_string(i + 1) + "  " + rows[i].title,
                     entry.summary(language),
                     picture_of(state.lessons.scenes_folder, entry.scene),
                     {},
                     entry.name,
                     rows[i].locked});
  }
  return cards;
}

namespace {

// In at most two lines.
std::string title_in_lines(const std::string& title, float width) {
  std::string lines = broken_lines(title, width);
  const std::size_t end = std::min(lines.find('\n'), lines.size());
  std::string rest = lines.substr(std::min(end + 1, lines.size()));
  std::replace(rest.begin(), rest.end(), '\n', ' ');
  const std::string first = shortened(lines.substr(0, end), width);
  return rest.empty() ? first : first + "\n" + shortened(rest, width);
}

}  // namespace

const GalleryCard* draw_cards(const Ui& ui, const std::vector<GalleryCard>& cards, float height,
                              GalleryPictures* pictures) {
  const Shades shades(ui.state.appearance.theme);
  const GalleryCard* chosen = nullptr;
  const ScrolledList list(ui, "cards", height, ui.px(10));
  if (!list) return nullptr;
  const float gap = ui.px(10), room = ImGui::GetContentRegionAvail().x, pad = ui.px(8);
  const int columns = std::max(static_cast<int>((room + gap) / (ui.px(190) + gap)), 1);
  const float width = std::floor((room - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns));
  const float picture = std::floor((width - 2 * pad) * 0.6f), text = line_height(ui.fonts, *ui.fonts.small);
  constexpr float lines = 5.5f;  // four of a sentence below a title of two
  const float tall = picture + line_height(ui.fonts, *ui.fonts.strong) + lines * text + 3 * pad;
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  int number = 0;
  for (const GalleryCard& card : cards) {
    const ImVec2 at{origin.x + static_cast<float>(number % columns) * (width + gap),
                    origin.y + static_cast<float>(number / columns) * (tall + gap)};
    ++number;
    ImGui::SetCursorScreenPos(at);
    if (ImGui::InvisibleButton(card.name.c_str(), {width, tall})) chosen = &card;
    const bool lit = ImGui::IsItemHovered() || ImGui::IsItemFocused();
    ui.publish(card.name);
    if (!ImGui::IsItemVisible()) continue;
    const ImVec2 end{at.x + width, at.y + tall};
    draw.AddRectFilled(at, end, to_imgui(lit ? shades.raised_hovered : shades.raised), ui.px(6));
    if (lit) draw.AddRect(at, end, to_imgui(shades.accent), ui.px(6), 0, ui.px(1.5f));
    const Rect frame{at.x + pad, at.y + pad, width - 2 * pad, picture};
    draw.AddRectFilled(corner(frame), opposite(frame), to_imgui(ui.colours.plan), ui.px(4));
    const GalleryPictures::Picture shown =
        pictures != nullptr ? pictures->of(card.picture) : GalleryPictures::Picture{};
    if (shown.texture != 0) {
      const float scale = std::min(frame.width / shown.width, frame.height / shown.height);
      const float w = shown.width * scale, h = shown.height * scale;
      const ImVec2 from{frame.x + (frame.width - w) / 2, frame.y + (frame.height - h) / 2};
      draw.AddImage((ImTextureID)shown.texture, from, {from.x + w, from.y + h});
    } else if (card.picture.empty()) {
      draw_icon(draw, Icon::plus, {frame.x + frame.width / 2, frame.y + frame.height / 2}, picture * 0.3f,
                to_imgui(ui.colours.dim_text));
    }
    const Colour ink = card.locked ? ui.colours.dim_text : ui.colours.text;
    float y = frame.bottom() + pad / 2;
    push_font(ui.fonts.strong);
    const std::string title = title_in_lines(card.title, frame.width);
    draw.AddText({frame.x, y}, to_imgui(ink), title.c_str());
    y += ImGui::CalcTextSize(title.c_str()).y + ui.px(2);
    pop_font();
    push_font(ui.fonts.small);
    draw.PushClipRect({frame.x, y}, {frame.right(), at.y + tall - pad / 2}, true);
    draw.AddText({frame.x, y}, to_imgui(card.locked ? ui.colours.dim_text : ink),
                 broken_lines(card.sentence, frame.width).c_str());
    draw.PopClipRect();
    pop_font();
    if (card.locked) tooltip(ui, card.name, ui.say("lesson.locked"));
  }
  const int rows = (static_cast<int>(cards.size()) + columns - 1) / columns;
  ImGui::SetCursorScreenPos({origin.x, origin.y + static_cast<float>(rows) * (tall + gap) - gap - 1});
  ImGui::Dummy({1, 1});
  close_edges(ui, ui.colours.window);
  return chosen;
}

}  // namespace raywalk
