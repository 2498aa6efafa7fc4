#include "gui/session.h"

#include "render/parallel.h"
#include "study/shot.h"
#include "text/file.h"
#include "text/file_path.h"
#include "view/document/document.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string_view>
#include <utility>

namespace raywalk {

namespace {

constexpr std::size_t max_settings = 1 << 16;  // bytes

std::string settings_path(const std::string& state_dir) { return state_dir + "/settings.json"; }

// Sets `to` to the choice of this name, if any.
template <Worded Choice>
Result<void> choose(const std::string& name, const char* what, Choice& to) {
  if (name.empty()) return {};
  if (const auto choice = named<Choice>(name)) {
    to = *choice;
    return {};
  }
  std::string expected;
  for (const auto& [choice, word] : words_of<Choice>) expected += (expected.empty() ? "" : ", ") + std::string(word);
  return tl::unexpected(Error{"", 0, 0, std::string("there is no ") + what + " '" + name + "'", "one of: " + expected});
}

/// Calls `with(key in the file, member of Settings, where a State has it)` for each setting, but for the language,
/// which the state has with its texts.
void each_setting(const auto& with) {
  with("theme", &Settings::theme, [](auto& state) -> auto& { return state.appearance.theme; });
  with("ui_scale", &Settings::ui_scale, [](auto& state) -> auto& { return state.appearance.ui_scale; });
  with("tab", &Settings::tab, [](auto& state) -> auto& { return state.appearance.tab; });
  with("tweens", &Settings::tweens, [](auto& state) -> auto& { return state.walk.tweens; });
  with("english_code", &Settings::english_code, [](auto& state) -> auto& { return state.appearance.english_code; });
  with("exchanged", &Settings::exchanged, [](auto& state) -> auto& { return state.appearance.exchanged; });
  with("code_part", &Settings::code_part, [](auto& state) -> auto& { return state.appearance.code_part; });
  with("presenter", &Settings::presenter, [](auto& state) -> auto& { return state.lessons.presenter; });
  with("link_page", &Settings::link_page, [](auto& state) -> auto& { return state.link.page; });
}

nlohmann::json settings_in(const std::string& state_dir) {
  const Result<std::string> bytes = read_file(settings_path(state_dir), max_settings);
  nlohmann::json json = nlohmann::json::parse(bytes.value_or(""), nullptr, false);
  return json.is_object() ? json : nlohmann::json::object();
}

nlohmann::json json_of(const auto& value) { return value; }
nlohmann::json json_of(const Worded auto& value) { return name_of(value); }
nlohmann::json json_of(const std::vector<Tab>& tabs) {
  nlohmann::json names = nlohmann::json::array();
  for (const Tab& tab : tabs) names.push_back(tab.word);
  return names;
}

// Sets `to` to what the file says, if that is of its type.
void read_into(bool& to, const nlohmann::json& from) {
  if (from.is_boolean()) to = from.get<bool>();
}
void read_into(double& to, const nlohmann::json& from) {
  if (from.is_number()) to = from.get<double>();
}
void read_into(std::string& to, const nlohmann::json& from) {
  if (from.is_string()) to = from.get<std::string>();
}
template <Worded Choice>
void read_into(Choice& to, const nlohmann::json& from) {
  if (from.is_string()) to = named<Choice>(from.get<std::string>()).value_or(to);
}
void read_into(std::vector<Tab>& to, const nlohmann::json& from) {
  for (const auto& each : from.is_array() ? from : nlohmann::json::array())
    if (const auto tab = each.is_string() ? named<Tab>(each.get<std::string>()) : std::nullopt) to.push_back(*tab);
}

nlohmann::json json_of(const Settings& settings) {
  nlohmann::json json;
  json["language"] = settings.language;
  each_setting([&](const char* key, auto member, auto) { json[key] = json_of(settings.*member); });
  return json;
}

}  // namespace

Settings settings_of(const State& state) {
  Settings settings{.language = std::string(state.appearance.language.code())};
  each_setting([&](const char*, auto member, auto in) { settings.*member = in(state); });
  return settings;
}

Settings read_settings(const std::string& state_dir) {
  Settings settings;
  if (state_dir.empty()) return settings;
  const nlohmann::json json = settings_in(state_dir);
  if (const auto at = json.find("language"); at != json.end()) read_into(settings.language, *at);
  each_setting([&](const char* key, auto member, auto) {
    if (const auto at = json.find(key); at != json.end()) read_into(settings.*member, *at);
  });
  settings.ui_scale = std::clamp(settings.ui_scale, min_ui_scale, max_ui_scale);
  settings.code_part = settings.code_part > 0 ? std::clamp(settings.code_part, min_code_part, max_code_part) : 0;
  return settings;
}

void write_settings(const std::string& state_dir, const Settings& before, const Settings& now) {
  if (state_dir.empty()) return;
  nlohmann::json json = settings_in(state_dir);
  const nlohmann::json was = json_of(before), is = json_of(now);
  for (const auto& [key, value] : is.items())
    if (value != was[key]) json[key] = value;
  std::error_code error;
  std::filesystem::create_directories(state_dir, error);
  const std::string text = json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
  static_cast<void>(write_file_atomically(settings_path(state_dir), text + "\n"));
}

Language language_of_environment(const Languages& languages) {
  for (const char* variable : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
    const char* const locale = std::getenv(variable);
    if (locale == nullptr || *locale == '\0') continue;  // as in POSIX: the first that is set and not empty
    const std::string_view whole(locale);
    return languages.find(whole.substr(0, whole.find_first_of("_.@"))).value_or(languages.english());
  }
  return languages.english();
}

Language language_for(const GuiOptions& options, const Settings& settings) {
  if (options.language) return *options.language;
  if (options.languages == nullptr) return {};
  if (const auto kept = options.languages->find(settings.language)) return *kept;
  return language_of_environment(*options.languages);
}

std::string state_folder(const GuiOptions& options) {
  if (!options.state_dir.empty()) return options.state_dir;
  if (const char* folder = std::getenv("XDG_STATE_HOME"); folder != nullptr && folder[0] == '/')
    return std::string(folder) + "/raywalk";
  if (const char* home = std::getenv("HOME"); home != nullptr && home[0] == '/')
    return std::string(home) + "/.local/state/raywalk";
  return {};
}

Result<State> start(const GuiOptions& options, const Stop& stop) {
  const std::string path = options.scene_path.empty() ? options.data_dir + "/scenes/classic.toml" : options.scene_path;
  const auto reading = std::make_shared<Result<SceneDocument>>();
  run_detached(stop, [reading, path] { *reading = read_scene(path); });
  Result<SceneDocument> document = std::move(*reading);
  if (!document) return tl::unexpected(document.error());
  // A screenshot shows this scene: without questions about an earlier one, and without leaving traces.
  const bool picture = !options.screenshot_path.empty();
  const std::string folder = picture ? std::string() : state_folder(options);
  const Settings settings = read_settings(folder);
  State state = make_state(std::move(*document), absolute_path(path), folder, stop, language_for(options, settings));
  state.lessons.folder = options.data_dir + "/lessons";
  state.lessons.scenes_folder = options.data_dir + "/scenes";
  const std::optional<std::string> warning = warning_of_file(state);
  restore_session(state);
  if (warning) inform_above(state, *warning);
  if (!options.broken_texts.empty())
    state.document.notice = Notice{Notice::Kind::error, fill("notice.broken_texts", state.appearance.language,
                                                             {{"why", options.broken_texts.front().text()}})};

  each_setting([&](const char*, auto member, auto in) { in(state) = settings.*member; });
  if (options.ui_scale > 0) state.appearance.ui_scale = std::clamp(options.ui_scale, min_ui_scale, max_ui_scale);
  state.appearance.theme = options.theme.value_or(state.appearance.theme);
  if (Result<void> chosen = choose(options.start_tab, "tab", state.appearance.tab); !chosen)
    return tl::unexpected(chosen.error());
  state.appearance.embedded = options.embedded;
  state.link.own_page = options.own_page;
  if (!options.link.empty()) {
    // An earlier session's work is asked about all the same.
    const auto asked = std::exchange(state.document.question, std::nullopt);
    update(state, action::OpenLink{options.link});
    if (asked) state.document.question = asked;
  }
  if (options.start_position) {
    const int position = *options.start_position;
    update(state, action::Jump{position < 0 ? state.walk.timeline->steps() + 1 + position : position});
  }
  Mode mode = state.walk.mode;
  if (Result<void> chosen = choose(options.start_mode, "mode", mode); !chosen) return tl::unexpected(chosen.error());
  if (mode != state.walk.mode) update(state, action::SetMode{mode});
  return state;
}

bool LiveImage::rests(const State& state) const {
  if (!begun_ || revision_ != state.document.revision || image_revision_ != state.picture.revision) return false;
  return preview_.finished() || (state.plan.drag && preview_.has_every_pixel());
}

namespace {

/// As many as the largest screens have: a scene may ask for a picture that no memory holds.
constexpr double most_pixels = 3840 * 2160;

PreviewSettings preview_settings(const State& state) {
  PreviewSettings settings;
  settings.size = study::shrunk(state.scene().image, most_pixels);
  settings.accelerator = state.picture.settings.accelerator;
  settings.samples = samples_seen(state, state.picture.settings.samples);
  settings.precision = state.picture.settings.single_precision ? Precision::float_ : Precision::double_;
  settings.heat = state.picture.settings.heat;
  settings.fault = fault_at_work(state);
  return settings;
}

}  // namespace

bool LiveImage::follow(const State& state, const Stop& stop) {
  if (begun_ && revision_ == state.document.revision && image_revision_ == state.picture.revision) return false;
  const PreviewSettings settings = preview_settings(state);
  const SceneSeen scene = pictured_scene(state);
  if (workers_.begin(*scene, state.document.contents.path, settings)) {
    preview_.reset_elsewhere(*scene, settings);
  } else {
    preview_.reset(*scene, settings, state.document.worlds.get(), stop);
  }
  revision_ = state.document.revision;
  image_revision_ = state.picture.revision;
  seconds_ = 0;
  begun_at_ = std::chrono::steady_clock::now();
  const bool is_another = std::exchange(document_, state.document.number) != state.document.number && begun_;
  if (is_another) preview_.blank();
  begun_ = true;
  return is_another;
}

bool LiveImage::work(const State& state, double milliseconds, const Stop& stop) {
  if (workers_.at_work()) {
    seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_at_).count();
    if (workers_.serve(preview_, !rests(state))) return !rests(state);
    seconds_ = 0;
    preview_.reset(*pictured_scene(state), preview_settings(state), state.document.worlds.get(), stop);
  }
  const auto begun = std::chrono::steady_clock::now();
  if (!rests(state)) preview_.refine(milliseconds, 0, stop);
  seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  return !rests(state);
}

double LiveImage::seconds_left() const {
  const double done = preview_.done();
  return done > 0 && done < 1 ? seconds_ * (1 - done) / done : 0;
}

bool Demo::ignores_question() const {
  const auto is_quit = [](const Action& action) { return action.is<action::Quit>(); };
  return !over() && !actions_[next_].is<action::AnswerQuestion>() && !actions_[next_].is<action::Wait>() &&
         std::any_of(actions_.begin() + static_cast<std::ptrdiff_t>(next_), actions_.end(), is_quit);
}

const Action* Demo::due(double seconds) {
  if (over()) return nullptr;
  waited_ += seconds;
  if (waited_ < pause) return nullptr;
  const Action& action = actions_[next_++];
  const auto* wait = action.as<action::Wait>();
  waited_ = wait == nullptr ? 0 : -std::clamp(wait->seconds, 0.0, max_wait);
  return &action;
}

}  // namespace raywalk
