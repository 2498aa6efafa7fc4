#pragma once
// The words that options take.

#include "accel/accelerator.h"
#include "math/words.h"
#include "trace/kernel.h"

#include <string_view>

namespace raywalk {

enum class StepFormat { text, json, html, svg };
template <>
inline constexpr Word<StepFormat> words_of<StepFormat>[] = {
    {StepFormat::text, "text"}, {StepFormat::json, "json"}, {StepFormat::html, "html"}, {StepFormat::svg, "svg"}};

}  // namespace raywalk
