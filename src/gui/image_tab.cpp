#include "gui/panes.h"
#include "gui/widgets.h"
#include "view/text.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

namespace {

// The largest rectangle of the picture's shape in the middle of `room`. Larger than the picture it is a whole multiple,
// so that all its pixels are alike.
Rect fitted(const Rect& room, int width, int height, float density) {
  const float across = std::max(room.width, 1.0f), down = std::max(room.height, 1.0f);
  float scale = std::min(across / static_cast<float>(width), down / static_cast<float>(height));
  if (scale * density > 1) scale = std::floor(scale * density) / density;
  const float w = std::floor(static_cast<float>(width) * scale), h = std::floor(static_cast<float>(height) * scale);
  return {std::round(room.x + (room.width - w) / 2), std::round(room.y + (room.height - h) / 2), w, h};
}

// The row that is the strip: marks at both sides and hairlines above and below it.
void mark_row(const Ui& ui, const Rect& image, float top, float bottom) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImU32 ink = to_imgui(ui.colours.selected);
  const float y = (top + bottom) / 2, r = ui.px(6);
  draw.AddTriangleFilled({image.x - ui.px(2), y}, {image.x - ui.px(2) - r, y - r}, {image.x - ui.px(2) - r, y + r},
                         ink);
  draw.AddTriangleFilled({image.right() + ui.px(2), y}, {image.right() + ui.px(2) + r, y + r},
                         {image.right() + ui.px(2) + r, y - r}, ink);
  const ImU32 faint = to_imgui(ui.colours.selected.with_alpha(120));
  draw.AddLine({image.x, top}, {image.right(), top}, faint);
  draw.AddLine({image.x, bottom}, {image.right(), bottom}, faint);
}

void mark_cell(const Ui& ui, const Rect& image, int cell, int cells, float middle) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float edge = image.width / static_cast<float>(cells), half = std::max(edge / 2, ui.px(4));
  const float x = image.x + (static_cast<float>(cell) + 0.5f) * edge;
  const ImVec2 least{x - half, middle - half}, most{x + half, middle + half};
  // White on black, to be seen on any picture.
  draw.AddRect(least, most, IM_COL32(0, 0, 0, 255), 0, 0, ui.px(3.5f));
  draw.AddRect(least, most, IM_COL32(255, 255, 255, 255), 0, 0, ui.px(1.5f));
}

}  // namespace

void image_tab(const Ui& ui, const Rect& where, const Picture& picture) {
  const float line = line_height(ui.fonts, *ui.fonts.small), side = ui.px(12);
  push_font(ui.fonts.small);
  if (picture.texture == 0) {
    label(ui.colours.dim_text, text(TextId::image_waiting));
    pop_font();
    return;
  }
  const Rect room{where.x + side, where.y + ui.px(2), where.width - 2 * side, where.height - line - ui.px(10)};
  const Rect image = fitted(room, picture.width, picture.height, ui.fonts.density);
  ui.publish("image", image);
  if (image.width >= 8 && image.height >= 8) {
    const Camera& camera = ui.state.scene().camera;
    const int cells = std::max(camera.screen.cells, 1);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddImage((ImTextureID)picture.texture, corner(image), opposite(image));
    const float row = image.height / static_cast<float>(picture.height);
    const float middle = image.y + static_cast<float>(picture.height / 2) * row + row / 2;
    const float half = std::max(row / 2, 0.5f) + ui.px(1.5f);
    mark_row(ui, image, std::round(middle - half), std::round(middle + half));
    if (const int cell = current_cell(ui.state); cell >= 0) mark_cell(ui, image, cell, cells, middle);

    ImGui::SetCursorScreenPos(corner(image));
    const bool clicked = ImGui::InvisibleButton("image", size(image));
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const bool near_row = ImGui::IsItemHovered() && std::abs(mouse.y - middle) < std::max(ui.px(14), half);
    if (near_row) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (clicked && near_row) {
      const float part = (mouse.x - image.x) / image.width;
      ui.act(action::JumpToCell{std::clamp(static_cast<int>(part * static_cast<float>(cells)), 0, cells - 1)});
    }
  }
  std::string status = std::string(text(TextId::image_row_marked));
  if (!picture.finished) status = percent_text(picture.done) + "  \u00b7  " + status;
  const float width = ImGui::CalcTextSize(status.c_str()).x;
  ImGui::SetCursorScreenPos({std::max(where.x + (where.width - width) / 2, where.x), where.bottom() - line - ui.px(4)});
  label(ui.colours.dim_text, status);
  pop_font();
}

}  // namespace raywalk
