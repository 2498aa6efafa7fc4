// A link holds a scene and a moment, opens nothing but a scene, and loses nothing.
#include "view/link/link.h"
#include "io/packed_text.h"
#include "io/scene_patch.h"
#include "lesson_state.h"
#include "random_actions.h"
#include "support/effort.h"
#include "text/file.h"
#include "view/document/document.h"
#include "view/document/question.h"
#include "view/link/qr_code.h"

#include "support/catch.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

using namespace raywalk;
using namespace raywalk::test;
using action::Answer;

namespace {

constexpr std::string_view page = "https://visualiser.example.org/raywalk/";

/// As on another machine, which knows nothing yet.
State elsewhere() {
  State state = state_with_lessons();
  update(state, action::SetLessonOptions{});
  update(state, action::ShowLessons{false});
  return state;
}

/// The letters of a state's link, which must have one.
std::string letters_of(const State& state) {
  const auto link = link_of(state);
  INFO((link ? std::string() : link.error().text()));
  REQUIRE(link.has_value());
  const std::string letters = write_link(*link);
  const auto read = read_link(letters);
  INFO(letters);
  REQUIRE(read.has_value());
  CHECK(*read == *link);
  CHECK(is_link(letters));
  return letters;
}

/// Opens the link of a state elsewhere, and compares what is seen there.
void check_it_arrives(const State& state) {
  const std::string letters = letters_of(state);
  INFO(letters);
  State other = elsewhere();
  update(other, action::OpenLink{std::string(page) + letters});
  INFO((other.document.notice ? other.document.notice->text : ""));
  // A lesson stands there with its title, and needs no notice.
  REQUIRE((other.document.notice ? other.document.notice->kind == Notice::Kind::info : other.lessons.open != nullptr));
  CHECK(other.scene() == state.scene());
  CHECK(other.walk.position == state.walk.position);
  CHECK(other.walk.timeline->steps() == state.walk.timeline->steps());
  CHECK(other.walk.pixel == state.walk.pixel);
  CHECK(other.effects.left_out == state.effects.left_out);
  CHECK(other.effects.depth == state.effects.depth);
  CHECK(other.walk.mode == state.walk.mode);
  CHECK(other.appearance.tab == state.appearance.tab);
  CHECK(other.appearance.language == state.appearance.language);
  CHECK(other.appearance.theme == state.appearance.theme);
  CHECK((other.lessons.open == nullptr) == (state.lessons.open == nullptr));
  if (state.lessons.open && other.lessons.open) {
    CHECK(other.lessons.open->lesson.name == state.lessons.open->lesson.name);
    CHECK(other.lessons.step == state.lessons.step);
  }
  // Nothing is lost on a longer way either.
  CHECK(letters_of(other) == letters);
}

State opened(const std::string& path) {
  State state = elsewhere();
  update(state, action::Open{path});
  return state;
}

std::string refusal(State& state, const std::string& link) {
  const Scene before = state.scene();
  const int position = state.walk.position;
  update(state, action::OpenLink{link});
  CHECK(state.scene() == before);
  CHECK(state.walk.position == position);
  CHECK(broken_promise(state) == "");
  if (!state.document.notice || state.document.notice->kind != Notice::Kind::error) return {};
  return state.document.notice->text;
}

}  // namespace

TEST_CASE("a link of every shipped scene opens at the same step") {
  for (const std::string& path : shipped_scenes()) {
    INFO(path);
    State state = opened(path);
    const int steps = state.walk.timeline->steps();
    for (const int position : {0, 1, steps / 2, steps}) {
      update(state, action::Jump{position});
      check_it_arrives(state);
    }
    // Unchanged, it is a name: short enough for a telephone.
    CHECK(page.size() + letters_of(state).size() <= max_qr_letters);
  }
}

TEST_CASE("a link has the mode, the tab, the language, the theme, the walked pixel and how it is traced") {
  State state = elsewhere();
  update(state, action::SetMode{Mode::move});
  check_it_arrives(state);
  update(state, action::SetTheme{Theme::projector});
  update(state, action::SetTab{StackRoom::tab});
  update(state, action::SetLanguage{"pt"});
  update(state, action::Jump{77});
  check_it_arrives(state);
  update(state, action::WalkPixel{300, 200, {441, 331}});
  update(state, action::Jump{5});
  check_it_arrives(state);
  update(state, action::Orbit{SpaceView::image, {0.3, 0.2}});
  update(state, action::WalkPixel{220, 165, {441, 331}});
  check_it_arrives(state);
  ImageSettings settings = state.picture.settings;
  settings.single_precision = true;
  settings.integrator = Integrator::path;
  settings.walk_samples = 3;
  update(state, action::SetImageSettings{settings});
  update(state, action::Jump{9});
  check_it_arrives(state);
  State other = elsewhere();
  update(other, action::OpenLink{letters_of(state)});
  CHECK(other.picture.settings == settings);
}

TEST_CASE("a link has what the effects bar leaves out and its depth, and nothing of a bar that leaves all as it is") {
  State state = opened(std::string(RAYWALK_SOURCE_DIR) + "/scenes/classic.toml");
  const int own = state.scene().limits.depth, steps = state.walk.timeline->steps();
  update(state, action::ShowEffects{true});
  CHECK(letters_of(state).find("effects") == std::string::npos);
  update(state, action::SwitchEffect{Effect::reflection, false});
  REQUIRE(state.walk.timeline->steps() < steps);
  update(state, action::Jump{20});
  CHECK(letters_of(state).find("/effects=2/") != std::string::npos);
  check_it_arrives(state);
  update(state, action::LimitDepth{own - 1});
  check_it_arrives(state);
  update(state, action::SwitchEffect{Effect::reflection, true});
  CHECK(letters_of(state).find("/effects=0," + std::to_string(own - 1) + "/") != std::string::npos);
  check_it_arrives(state);
  update(state, action::LimitDepth{own});
  CHECK(letters_of(state).find("effects") == std::string::npos);

  // Those that the scene is seen without too, and of a lesson.
  State distributed = opened(std::string(RAYWALK_SOURCE_DIR) + "/scenes/distributed.toml");
  for (const Effect effect : {Effect::gloss, Effect::penumbra, Effect::shadows})
    update(distributed, action::SwitchEffect{effect, false});
  REQUIRE(distributed.effects.left_out.any());
  check_it_arrives(distributed);
  State lesson = state_with_lessons();
  update(lesson, action::OpenLesson{"04-reflection"});
  update(lesson, action::SwitchEffect{Effect::reflection, false});
  update(lesson, action::Jump{20});
  check_it_arrives(lesson);

  // It shows what is left out, and another link brings it back.
  State other = elsewhere();
  update(other, action::OpenLink{letters_of(lesson)});
  CHECK(other.effects.shown);
  update(other, action::OpenLink{"#v=1/scene=classic/step=20"});
  CHECK_FALSE(other.effects.leaves_out());
  // All that anybody may write, of any scene, and of a bug, whose tracer leaves nothing out.
  for (const char* begun : {"#v=1/scene=classic", "#v=1/scene=beams", "#v=1/scene=everything", "#v=1/bug=2"}) {
    INFO(begun);
    State asked = elsewhere();
    update(asked, action::OpenLink{std::string(begun) + "/effects=ffff,50/step=9"});
    CHECK(asked.walk.position == 9);
    CHECK(asked.effects.left_out.any() != asked.bugs.hunt.has_value());
    CHECK(broken_promise(asked) == "");
  }
}

TEST_CASE("a link that tells no scene shows the one that is open as it says") {
  State state = elsewhere();
  const Scene before = state.scene();
  REQUIRE_FALSE(before.objects.empty());
  update(state, action::OpenLink{"#v=1/step=7/mode=trace/theme=projector"});
  CHECK(state.scene() == before);
  CHECK(state.appearance.theme == Theme::projector);
  CHECK(state.walk.position == 7);
  // That of a scene with nothing in it is told.
  Link empty;
  empty.sum = scene_sum(Scene{});
  update(state, action::OpenLink{write_link(empty)});
  CHECK(state.scene() == Scene{});
}

TEST_CASE("every step of every lesson has a link, of at most 2,000 letters, that opens it elsewhere") {
  State state = state_with_lessons();
  std::size_t longest = 0, lesson = 0;
  for (const LessonEntry& entry : std::vector(state.lessons.list)) {
    INFO(entry.name);
    if (left_out(lesson++, 4)) continue;
    update(state, action::OpenLesson{entry.name});
    REQUIRE(state.lessons.open);
    for (int step = 0; step < entry.steps; ++step) {
      INFO(step);
      update(state, action::GoToLessonStep{step});
      REQUIRE(state.lessons.step == step);
      longest = std::max(longest, page.size() + letters_of(state).size());
      // All that is opened elsewhere is played there first: the first or the last step stands for the others.
      if (step == (lesson % 2 == 0 ? 0 : entry.steps - 1)) check_it_arrives(state);
    }
    update(state, action::LeaveLesson{});
  }
  CHECK(longest <= max_qr_letters);
}

TEST_CASE("a lesson that was changed arrives as it was changed, and may be a locked one") {
  State state = state_with_lessons();
  update(state, action::OpenLesson{"05-refraction"});
  update(state, action::GoToLessonStep{1});
  update(state, action::AddObject{action::ObjectKind::transparent_sphere});
  check_it_arrives(state);
  CHECK(page.size() + letters_of(state).size() <= 2000);
}

TEST_CASE("links of changed scenes hold only what differs, and arrive") {
  State state = elsewhere();
  drag_by(state, {TargetKind::object, index_of_object(state.scene(), "Solid Sphere")}, {20, 10});
  check_it_arrives(state);
  CHECK(page.size() + letters_of(state).size() <= max_qr_letters);
  update(state, action::AddObject{action::ObjectKind::polygon});
  update(state, action::AddObject{action::ObjectKind::light});
  update(state, action::Select{{TargetKind::object, 0}});
  update(state, action::RemoveSelected{});
  update(state, action::Rename{{TargetKind::object, 0}, "Esfera \"de\" vidrio/1&2#\xE2\x82\xAC"});
  check_it_arrives(state);
  CHECK(page.size() + letters_of(state).size() <= 2000);

  // Of a new scene too, which begins with none, and of one that is kept elsewhere.
  update(state, action::New{});
  update(state, action::AnswerQuestion{Answer::discard});
  update(state, action::AddObject{action::ObjectKind::solid_sphere});
  check_it_arrives(state);
  const TemporaryFolder folder;
  update(state, action::SaveAs{folder.file("mine.toml")});
  check_it_arrives(state);
  State busy = busy_state();
  busy.lessons.scenes_folder = state.lessons.scenes_folder;
  check_it_arrives(busy);
}

TEST_CASE("links of scenes changed at random arrive") {
  const TemporaryFolder folder;
  const int walks = rounds(24);
  for (int seed = 0; seed < walks; ++seed) {
    RandomActions random(static_cast<unsigned>(seed), folder.path());
    State state = opened(seed % 3 == 0 ? shipped_scenes()[static_cast<std::size_t>(seed) % shipped_scenes().size()]
                                       : std::string(RAYWALK_SOURCE_DIR) + "/scenes/classic.toml");
    for (int i = 0; i < 12; ++i) {
      update(state, random.next_edit(state));
      update(state, action::CancelPrompt{});
    }
    update(state, action::Jump{random.whole(0, state.walk.timeline->steps())});
    INFO(seed);
    check_it_arrives(state);
  }
}

TEST_CASE("links that earlier versions made are opened still") {
  // A line each: the link, and behind a blank what it must show: steps in all, then the title.
  int count = 0;
  std::ifstream samples(std::string(RAYWALK_SOURCE_DIR) + "/tests/view/links/version_1.txt");
  for (std::string line; std::getline(samples, line); ++count) {
    std::istringstream in(line);
    std::string link, title;
    int position = 0, steps = 0;
    in >> link >> position >> steps >> std::ws;
    std::getline(in, title);
    INFO(line);
    State state = elsewhere();
    update(state, action::OpenLink{link});
    CHECK(state.scene().title == title);
    CHECK(state.walk.position == position);
    CHECK(state.walk.timeline->steps() == steps);
    CHECK((!state.document.notice || state.document.notice->kind == Notice::Kind::info));
  }
  CHECK(count >= 8);
}

TEST_CASE("opening a link asks before unsaved work is lost, and keeps it where it cannot be opened") {
  const TemporaryFolder folder;
  const std::string link = write_link(Link{.scene = "glass", .step = 3});
  State state = saved_state(folder);
  state.lessons.folder = std::string(RAYWALK_SOURCE_DIR) + "/lessons";
  state.lessons.scenes_folder = std::string(RAYWALK_SOURCE_DIR) + "/scenes";
  make_dirty(state);
  const Scene mine = state.scene();
  update(state, action::OpenLink{link});
  REQUIRE(state.document.question);
  CHECK(state.scene() == mine);
  update(state, action::AnswerQuestion{Answer::cancel});
  CHECK(state.scene() == mine);
  CHECK(state.document.dirty);
  update(state, action::OpenLink{write_link(Link{.scene = "no_such_scene"})});
  REQUIRE(state.document.question);
  update(state, action::AnswerQuestion{Answer::discard});
  CHECK(state.scene() == mine);
  CHECK(state.document.dirty);
  update(state, action::OpenLink{link});
  update(state, action::AnswerQuestion{Answer::save});
  CHECK_FALSE(state.document.question);
  CHECK(read_document(folder.file("scene.toml")).scene == mine);
  CHECK(state.scene() == read_document(state.lessons.scenes_folder + "/glass.toml").scene);
  CHECK(state.walk.position == 3);
}

TEST_CASE("opening a link asks before a changed scene of a lesson is lost, and keeps it where it cannot be opened") {
  State state = state_with_lessons();
  update(state, action::OpenLesson{"01-ray-casting"});
  REQUIRE(state.lessons.open);
  make_dirty(state);
  REQUIRE(state.document.dirty);
  const Scene changed = state.scene();
  for (const Link& link : {Link{.scene = "no_such_scene"}, Link{.lesson = "no-such-lesson", .lesson_step = 1}}) {
    update(state, action::OpenLink{write_link(link)});
    REQUIRE(state.document.question);
    CHECK_THAT(question_panel(state).text, contains("lesson's scene") && contains("link"));
    update(state, action::AnswerQuestion{Answer::discard});
    CHECK_FALSE(state.document.question);
    CHECK(state.scene() == changed);
    CHECK(state.document.dirty);
  }
  update(state, action::OpenLink{write_link(Link{.scene = "glass"})});
  REQUIRE(state.document.question);
  CHECK(state.scene() == changed);
  update(state, action::AnswerQuestion{Answer::discard});
  CHECK_FALSE(state.document.dirty);
  CHECK_FALSE(state.lessons.open);
}

TEST_CASE("what is no link is refused with a sentence, and changes nothing") {
  State state = elsewhere();
  const std::string begun = "#v=1/scene=classic";
  for (const std::string& link : std::vector<std::string>{
           "",
           "#",
           "#v=",
           "#v=x",
           "#v=0/scene=classic",
           "#scene=classic",
           "#v=2/scene=classic",
           "#v=99999999999999999999",
           begun + "/step=-1",
           begun + "/step=99999999999999999999",
           begun + "/step=1.5",
           begun + "/step=",
           begun + "/st",
           "#v=1/scene=../../etc/passwd",
           "#v=1/scene=%2e%2e%2fetc",
           "#v=1/scene=",
           "#v=1/scene=nothing_of_that_name",
           "#v=1/lesson=99-nothing",
           "#v=1/lesson=../lessons",
           begun + "/mode=help",
           begun + "/tab=kitchen",
           begun + "/lang=xxxxxx",
           begun + "/theme=pink",
           begun + "/pixel=1,2,3",
           begun + "/pixel=5,5,5,5",
           begun + "/pixel=1,1,99999999,3",
           begun + "/changes=!!!",
           begun + "/changes=abc",
           begun + "/samples=0",
           begun + "/effects=",
           begun + "/effects=10000",
           begun + "/effects=-1",
           begun + "/effects=g",
           begun + "/effects=2,",
           begun + "/effects=2,0",
           begun + "/effects=2,51",
           begun + "/effects=2,3,4",
           begun + "/effects=99999999999999999999",
           begun + "/bug=0",
           begun + "/bug=99",
           begun + "/sum=xyz",
           begun + "/changes=" + pack_text("[1, 2"),
           begun + "/changes=" + pack_text("7"),
           begun + "/changes=" + pack_text(std::string(20000, '[')),
           begun + "/changes=" + pack_text(R"({"object":{"Solid Sphere":{"radius":-1}}})"),
           begun + "/changes=" + pack_text(R"({"camera":null})"),
           begun + "/changes=" + pack_text("{\"a\\nb = 1\\n[camera]\\n\":1}"),
           begun + "/changes=" + pack_text(R"({"object":{"A":{"type":"mesh","file":"/etc/passwd"}}})"),
           begun + "/changes=" + pack_text(R"({"object":{"Floor":{"material":{"texture":{"file":"/dev/zero"}}}}})"),
           begun + "/changes=" + pack_text(R"({"image":{"width":60000,"height":60000}})"),
           begun + "/changes=" + pack_text(R"({"render":{"photons":{"count":1000001}}})"),
           begun + "/changes=" + pack_text("{\"title\":\"" + std::string(1 << 20, 'x') + "\"}"),
           begun + "/camera=" + pack_text(R"({"camera":{"up":[0,0,0]}})"),
           begun + "/x=" + std::string(max_link, 'x')}) {
    INFO(link.substr(0, 200));
    CHECK(refusal(state, link).size() > 20);
    CHECK(refusal(state, link).size() < 400);
  }
  // Parts of a later version are passed over, and what a messenger escapes is read.
  update(state, action::OpenLink{"#v=1/scene=glass/fresh=fish/step%3D4"});
  CHECK(state.walk.position == 4);
}

TEST_CASE("a step of no lesson is none") {
  const auto read = read_link("#v=1/scene=glass/at=2");
  REQUIRE(read.has_value());
  CHECK(*read == Link{.scene = "glass"});
  CHECK(read_link(write_link(*read)).value() == *read);
}

TEST_CASE("a link of another version's scene says so") {
  State state = elsewhere();
  const std::string changes = R"({"object":{"Solid Sphere":{"radius":0.5}}})";
  const auto base = read_document(state.lessons.scenes_folder + "/classic.toml");
  update(state,
         action::OpenLink{write_link(Link{.scene = "classic", .changes = changes, .sum = scene_sum(base.scene)})});
  const std::string same = state.document.notice->text;
  update(state,
         action::OpenLink{write_link(Link{.scene = "classic", .changes = changes, .sum = scene_sum(base.scene) + 1})});
  CHECK(state.document.notice->text != same);
  CHECK(std::get<Sphere<double>>(
            state.scene().objects[static_cast<std::size_t>(index_of_object(state.scene(), "Solid Sphere"))].shape)
            .radius == 0.5);
}

TEST_CASE("what does not fit into a link is offered as a file") {
  const TemporaryFolder folder;
  const std::string scenes = std::string(RAYWALK_SOURCE_DIR) + "/scenes/";
  std::filesystem::copy_file(scenes + "mesh.toml", folder.file("mesh.toml"));
  std::filesystem::copy_file(scenes + "ball.ply", folder.file("own.ply"));
  std::string text = read_file(folder.file("mesh.toml"), max_scene_bytes).value();
  for (std::size_t at; (at = text.find("ball.ply")) != std::string::npos;) text.replace(at, 8, "own.ply");
  REQUIRE(write_file_atomically(folder.file("mesh.toml"), text));
  State state = opened(folder.file("mesh.toml"));
  REQUIRE(state.document.path == folder.file("mesh.toml"));
  CHECK_FALSE(link_of(state).has_value());
  update(state, action::CopyLink{});
  CHECK(state.link.shown);
  CHECK(state.link.letters.empty());
  CHECK(state.link.why_not.find("own.ply") != std::string::npos);
  CHECK(state.link.copies == 0);
  // The shipped mesh itself needs no file from anybody.
  check_it_arrives(opened(scenes + "mesh.toml"));
  // Who opens a link has not chosen how long to wait.
  State slow = opened(scenes + "caustic.toml");
  Scene many = slow.scene();
  many.render.photons.count = 1'000'001;
  commit(slow, many);
  update(slow, action::CopyLink{});
  CHECK(slow.link.why_not.find("1000001 photons") != std::string::npos);
  --many.render.photons.count;
  commit(slow, many);
  check_it_arrives(slow);
  // A copy of the scene beside a link to the shipped file does not either.
  State shipped = opened(scenes + "mesh.toml");
  update(shipped, action::SaveAs{folder.file("near.toml")});
  CHECK(link_of(shipped).has_value());
}

TEST_CASE("a link is copied and shown for the page that it leads to") {
  State state = elsewhere();
  update(state, action::CopyLink{});
  CHECK(state.link.copies == 1);
  CHECK(state.link.copied.starts_with("raywalk:#v=1/scene=classic/"));
  update(state, action::SetLinkPage{"https://example.org/r/#v=1/scene=glass"});
  update(state, action::ShowLink{true});
  CHECK(address_shown(state).starts_with("https://example.org/r/#v=1/scene=classic/"));
  const auto code = qr_code(address_shown(state));
  REQUIRE(code);
  // Dark corners of 7 x 7 squares at three of the four corners.
  for (const auto& [column, row] : {std::pair{0, 0}, {code->side - 7, 0}, {0, code->side - 7}})
    CHECK((code->is_dark(column, row) && code->is_dark(column + 6, row + 6) && code->is_dark(column + 3, row + 3) &&
           !code->is_dark(column + 1, row + 1)));
  CHECK_FALSE(qr_code(std::string(max_qr_letters + 1, 'x')));
  update(state, action::ShowLink{false});
  CHECK_FALSE(state.link.shown);
}

TEST_CASE("a link of a bug opens its hunt, and the scene before it comes back") {
  State state = elsewhere();
  update(state, action::ShowBugs{true});
  update(state, action::HuntBug{3});
  update(state, action::Jump{20});
  const std::string letters = letters_of(state);
  State other = elsewhere();
  make_dirty(other);
  const Scene own = other.scene();
  update(other, action::OpenLink{letters});
  REQUIRE(other.bugs.hunt);
  CHECK(other.bugs.hunt->number == 3);
  CHECK(other.walk.position == 20);
  update(other, action::LeaveHunt{});
  CHECK(other.scene() == own);
  CHECK(other.document.dirty);
}

TEST_CASE("packed text is read back, and only that") {
  for (const std::string& text :
       std::vector<std::string>{"", "a", "{\"object\":{}}", std::string(5000, 'x'), std::string("\0\xff", 2)}) {
    const std::string letters = pack_text(text);
    CHECK(letters.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_") ==
          std::string::npos);
    CHECK(unpack_text(letters, 5000).value_or("?") == text);
    if (text.size() > 1) {
      CHECK_FALSE(unpack_text(letters, text.size() - 1).has_value());
      CHECK_FALSE(unpack_text(std::string_view(letters).substr(0, letters.size() - 2), 5000).has_value());
      CHECK_FALSE(unpack_text(letters + "AAAA", 5000).has_value());
    }
  }
}

// Writes the lines of tests/view/links that are of this version.
TEST_CASE("samples of links", "[.]") {
  const auto sample = [](const State& state) {
    std::printf("%s %d %d %s\n", letters_of(state).c_str(), state.walk.position, state.walk.timeline->steps(),
                state.scene().title.c_str());
  };
  for (const char* name : {"classic", "glass", "sphereflake"}) {
    State state = opened(std::string(RAYWALK_SOURCE_DIR) + "/scenes/" + name + ".toml");
    update(state, action::Jump{33});
    sample(state);
  }
  State state = elsewhere();
  drag_by(state, {TargetKind::object, index_of_object(state.scene(), "Polygon")}, {15, -10});
  update(state, action::AddObject{action::ObjectKind::transparent_sphere});
  update(state, action::AddObject{action::ObjectKind::light});
  sample(state);
  update(state, action::Orbit{SpaceView::image, {0.4, 0.1}});
  update(state, action::WalkPixel{100, 250, {441, 331}});
  sample(state);
  State plainer = opened(std::string(RAYWALK_SOURCE_DIR) + "/scenes/classic.toml");
  update(plainer, action::SwitchEffect{Effect::reflection, false});
  update(plainer, action::Jump{20});
  sample(plainer);
  update(plainer, action::LimitDepth{2});
  sample(plainer);
  State lesson = state_with_lessons();
  update(lesson, action::OpenLesson{"05-refraction"});
  update(lesson, action::GoToLessonStep{2});
  sample(lesson);
  update(lesson, action::AddObject{action::ObjectKind::solid_sphere});
  sample(lesson);
  State busy = busy_state();
  busy.lessons.scenes_folder = state.lessons.scenes_folder;
  sample(busy);
  State bug = elsewhere();
  update(bug, action::HuntBug{2});
  sample(bug);
}
