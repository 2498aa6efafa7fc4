#pragma once
// What *New* and *Open* begin with: the scenes and lessons that are shipped, as pictures with a sentence each.

#include "gui/ui.h"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace raywalk {

class Texture;  // gui/window.h

/// Pictures of files, each read when it is first asked for.
class GalleryPictures {
 public:
  GalleryPictures();
  ~GalleryPictures();
  GalleryPictures(const GalleryPictures&) = delete;
  GalleryPictures& operator=(const GalleryPictures&) = delete;

  struct Picture {
    std::uintptr_t texture = 0;  ///< 0: there is none
    float width = 0, height = 0;
  };
  [[nodiscard]] Picture of(const std::string& path);
  /// All are read again.
  void forget();

 private:
  struct Kept;
  std::map<std::string, std::unique_ptr<Kept>> kept_;
};

struct GalleryCard {
  std::string name;  ///< of its button: "scene/classic"
  std::string title, sentence, picture;
  std::string path;    ///< of a scene
  std::string lesson;  ///< else of a lesson; both empty: a new scene
  bool locked = false;
};
/// A new scene, then the shipped ones.
[[nodiscard]] std::vector<GalleryCard> scene_cards(const State& state);
[[nodiscard]] std::vector<GalleryCard> lesson_cards(const State& state);

/// Draws them in a region of this height that scrolls, and returns the one that was chosen, or null.
const GalleryCard* draw_cards(const Ui& ui, const std::vector<GalleryCard>& cards, float height,
                              GalleryPictures* pictures);

}  // namespace raywalk
