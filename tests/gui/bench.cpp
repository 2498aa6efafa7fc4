#include "gui/bench.h"

#include "gui/style.h"
#include "io/scene_file.h"
#include "support/catch.h"
#include "support/languages.h"

#include <utility>

namespace raywalk::test {

State classic() {
  auto document = read_scene(std::string(RAYWALK_SOURCE_DIR) + "/scenes/classic.toml");
  REQUIRE(document.has_value());
  return make_state(std::move(*document));
}

State classic_with_lessons() {
  State state = classic();
  state.lessons.folder = std::string(RAYWALK_SOURCE_DIR) + "/lessons";
  state.lessons.scenes_folder = std::string(RAYWALK_SOURCE_DIR) + "/scenes";
  return state;
}

Bench::Bench(State initial, float width, float height, const FontFiles& faces)
    : state(std::move(initial)), interface_(std::string(RAYWALK_SOURCE_DIR) + "/scenes"), faces_(faces) {
  if (state.appearance.language.others().all().size() == 1)
    state.appearance.language = in_english;  // so that it can be changed
  context_ = ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.DisplaySize = {width, height};
  io.DeltaTime = 1.0f / 60;
  io.ConfigInputTextCursorBlink = false;
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;  // as the window's, which draws more than 65,536 vertices
#if IMGUI_VERSION_NUM >= 19200
  io.BackendFlags |= ImGuiBackendFlags_RendererHasTextures;
#endif
#if IMGUI_VERSION_NUM < 18700
  for (int key = 0; key < ImGuiKey_COUNT; ++key) io.KeyMap[key] = key;
#endif
  move_to(-1, -1);
}

Bench::~Bench() { ImGui::DestroyContext(context_); }

void Bench::take_actions() {
  for (const Action& action : interface_.take_actions()) {
    actions.push_back(action);
    if (obedient) update(state, action);
  }
}

void Bench::rescale() {
  set_style(ImGui::GetStyle(), state.appearance.theme, unit);
  if (std::exchange(fonts_unit_, unit) == unit) return;
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  // Mostly any face will do, and ImGui's own is the same on every machine.
  fonts_ = build_fonts(atlas, faces_, unit, 1);
#if IMGUI_VERSION_NUM < 19200
  unsigned char* pixels = nullptr;
  int across = 0, down = 0;
  atlas.GetTexDataAsRGBA32(&pixels, &across, &down);
#endif
}

void Bench::frame() {
  rescale();
  ImGui::NewFrame();
  costs_.work(state, 20);
  PictureView picture{1, 441, 331, 0.5, true, false};
  picture.costs = &costs_;
  picture.cost_texture = 1;
  interface_.draw(state, fonts_, unit, dpi, picture);
  ImGui::Render();
  take_actions();
}

void Bench::frames(int count) {
  for (int i = 0; i < count; ++i) frame();
}

void Bench::resize(float width, float height) {
  ImGui::GetIO().DisplaySize = {width, height};
  frames(settle);
}

void Bench::move_to(float x, float y) {
#if IMGUI_VERSION_NUM >= 18700
  ImGui::GetIO().AddMousePosEvent(x, y);
#else
  ImGui::GetIO().MousePos = {x, y};
#endif
  frames(settle);
}

void Bench::press(int button) {
#if IMGUI_VERSION_NUM >= 18700
  ImGui::GetIO().AddMouseButtonEvent(button, true);
#else
  ImGui::GetIO().MouseDown[button] = true;
#endif
  frames(settle);
}

void Bench::release(int button) {
#if IMGUI_VERSION_NUM >= 18700
  ImGui::GetIO().AddMouseButtonEvent(button, false);
#else
  ImGui::GetIO().MouseDown[button] = false;
#endif
  frames(settle);
}

void Bench::wheel(float clicks) {
#if IMGUI_VERSION_NUM >= 18700
  ImGui::GetIO().AddMouseWheelEvent(0, clicks);
#else
  ImGui::GetIO().MouseWheel = clicks;
#endif
  frames(1);
}

Rect Bench::rect(const std::string& item) const {
  const auto found = interface_.items().find(item);
  INFO("no item is called " << item);
  REQUIRE(found != interface_.items().end());
  return found->second;
}

void Bench::point_at(const std::string& item) {
  const Rect where = rect(item);
  move_to(where.x + where.width / 2, where.y + where.height / 2);
}

void Bench::click(const std::string& item) {
  point_at(item);
  press();
  release();
}

void Bench::double_click(const std::string& item) {
  point_at(item);
  press();
  release();
  press();
  release();
}

void Bench::drag(const std::string& item, float dx, float dy) {
  const Rect where = rect(item);
  const float x = where.x + where.width / 2, y = where.y + where.height / 2;
  move_to(x, y);
  press();
  for (const float part : {0.3f, 0.6f, 1.0f}) move_to(x + part * dx, y + part * dy);
  release();
}

void Bench::key(const std::string& written) {
  REQUIRE(is_key(key_press(written).key));
  interface_.press(state, fonts_, unit, dpi, key_press(written));
  take_actions();
  frames(settle);
}

void Bench::repeat(const std::string& written) {
  KeyPress press = key_press(written);
  press.repeated = true;
  interface_.press(state, fonts_, unit, dpi, press);
  take_actions();
  frames(settle);
}

void Bench::type(const std::string& text) {
  ImGui::GetIO().AddInputCharactersUTF8(text.c_str());
  frames(settle);
}

void Bench::hold(ImGuiKey_ key, bool down) {
#if IMGUI_VERSION_NUM >= 18700
  ImGui::GetIO().AddKeyEvent(static_cast<ImGuiKey>(key), down);
#else
  ImGui::GetIO().KeysDown[key] = down;
#endif
}

void Bench::enter() {
  for (const bool down : {true, false}) {
    hold(ImGuiKey_Enter, down);
    frames(settle);
  }
}

int Bench::vertices() const { return ImGui::GetDrawData()->TotalVtxCount; }

}  // namespace raywalk::test
