#pragma once
// The words that options take.

#include "accel/accelerator.h"
#include "trace/kernel.h"

#include <string_view>

namespace raywalk {

[[nodiscard]] constexpr std::string_view precision_name(Precision precision) {
  switch (precision) {
    case Precision::float_:
      return "float";
    case Precision::double_:
      return "double";
  }
  return "";
}

enum class StepFormat { text, json, html, svg };
[[nodiscard]] constexpr std::string_view step_format_name(StepFormat format) {
  switch (format) {
    case StepFormat::text:
      return "text";
    case StepFormat::json:
      return "json";
    case StepFormat::html:
      return "html";
    case StepFormat::svg:
      return "svg";
  }
  return "";
}

}  // namespace raywalk
