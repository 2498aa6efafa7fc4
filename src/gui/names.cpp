#include "gui/names.h"

namespace raywalk {

std::string_view name_of(Mode mode) {
  switch (mode) {
    case Mode::move:
      return "move";
    case Mode::trace:
      return "trace";
    case Mode::help:
      return "help";
  }
  return "";
}

std::string_view name_of(Grain grain) {
  switch (grain) {
    case Grain::line:
      return "line";
    case Grain::ray:
      return "ray";
    case Grain::pixel:
      return "pixel";
    case Grain::over:
      return "over";
    case Grain::out:
      return "out";
  }
  return "";
}

std::string_view name_of(Tab tab) {
  switch (tab) {
    case Tab::image:
      return "image";
    case Tab::tree:
      return "tree";
    case Tab::stack:
      return "stack";
    case Tab::legend:
      return "legend";
    case Tab::cost:
      return "cost";
    case Tab::equation:
      return "equation";
    case Tab::microscope:
      return "microscope";
    case Tab::structure:
      return "structure";
  }
  return "";
}

std::string_view name_of(Theme theme) {
  switch (theme) {
    case Theme::dark:
      return "dark";
    case Theme::projector:
      return "projector";
  }
  return "";
}

std::string_view name_of(Question::Kind kind) {
  switch (kind) {
    case Question::Kind::unsaved:
      return "unsaved";
    case Question::Kind::recover:
      return "recover";
    case Question::Kind::overwrite:
      return "overwrite";
  }
  return "";
}

std::string_view name_of(PathPrompt prompt) {
  switch (prompt) {
    case PathPrompt::none:
      return "";
    case PathPrompt::open:
      return "open";
    case PathPrompt::save_as:
      return "save_as";
    case PathPrompt::save_predictions:
      return "save_predictions";
    case PathPrompt::export_walk:
      return "export";
  }
  return "";
}

}  // namespace raywalk
