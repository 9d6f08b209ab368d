#include "app/cli/options/PictureValues.h"

#include "app/cli/options/CommonOptions.h"
#include "viewport/render/OffscreenRenderer.h"

#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>

namespace rubble {
namespace {

constexpr std::pair<const char*, StandardView> kViews[] = {
    {"front", StandardView::Front},  {"back", StandardView::Back}, {"right", StandardView::Right},
    {"left", StandardView::Left},    {"top", StandardView::Top},   {"bottom", StandardView::Bottom},
    {"iso", StandardView::Isometric}};

/// Parses two numbers separated by `separator`.
template <class Number>
std::optional<std::pair<Number, Number>> pairOf(const std::string& text, char separator) {
    std::pair<Number, Number> numbers;
    const char* end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, numbers.first);
    if (first.ec != std::errc() || first.ptr == end || *first.ptr != separator) return std::nullopt;
    const auto second = std::from_chars(first.ptr + 1, end, numbers.second);
    if (second.ec != std::errc() || second.ptr != end) return std::nullopt;
    return numbers;
}

}  // namespace

std::optional<ImageSize> parsePictureSize(const std::string& text) {
    const auto numbers = pairOf<int>(text, 'x');
    if (!numbers) return std::nullopt;
    const auto isSide = [](int pixels) { return pixels >= 1 && pixels <= kMaxImageSide; };
    if (!isSide(numbers->first) || !isSide(numbers->second)) return std::nullopt;
    return ImageSize{numbers->first, numbers->second};
}

std::optional<Camera> parseCamera(const std::string& text) {
    for (const auto& [word, view] : kViews) {
        if (text == word) return alignedTo(Camera{}, view);
    }
    const auto degrees = pairOf<double>(text, ',');
    if (!degrees || !(std::abs(degrees->first) <= 360.0) || !(std::abs(degrees->second) <= 90.0)) return std::nullopt;
    constexpr double kDegree = std::numbers::pi / 180.0;
    return orbited(Camera{}, degrees->first * kDegree, degrees->second * kDegree);
}

std::string viewWords() {
    std::vector<std::string> words;
    for (const auto& [word, view] : kViews) words.emplace_back(word);
    return joinedText(words);
}

}  // namespace rubble
