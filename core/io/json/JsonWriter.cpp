#include "core/io/json/JsonWriter.h"

#include "core/base/Assert.h"
#include "core/io/json/JsonText.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace rubble {
namespace {

/// Whether a character may not be written as it is. Those beyond ASCII are checked.
bool needsEscape(char letter) {
    const auto code = static_cast<unsigned char>(letter);
    return code < 0x20 || code >= 0x80 || letter == '"' || letter == '\\';
}

}  // namespace

char* JsonWriter::startLine(char* at) const {
    *at++ = '\n';
    const std::size_t indentation = 2 * m_open.size();
    std::memset(at, ' ', indentation);
    return at + indentation;
}

/// place() for any layout.
char* JsonWriter::placeOnLine(std::string_view key, std::size_t size) {
    char* at = m_text.reserve(kMaxPunctuation + 2 * m_open.size() + key.size() + size);
    JsonLayout layout = m_layout;
    if (!m_open.empty()) {
        Container& container = m_open.back();
        layout = container.layout;
        RUBBLE_ASSERT(key.empty() == (container.end == ']'));
        if (!container.isEmpty) *at++ = ',';
        switch (layout) {
            case JsonLayout::Indented: at = startLine(at); break;
            case JsonLayout::Inline:
                if (!container.isEmpty) *at++ = ' ';
                break;
            case JsonLayout::Compact: break;
            case JsonLayout::CompactLines:
                if (!container.isEmpty || container.end == ']') *at++ = '\n';
                break;
        }
        container.isEmpty = false;
    }
    if (key.empty()) return at;
    at = writeKey(key, at);
    if (layout < JsonLayout::Compact) *at++ = ' ';
    return at;
}

void JsonWriter::open(std::string_view key, char start, char end, std::optional<JsonLayout> layout) {
    const JsonLayout inherited =
        !m_open.empty() && m_open.back().layout == JsonLayout::CompactLines ? JsonLayout::Compact : this->layout();
    char* at = place(key, 1);
    *at++ = start;
    m_text.setEnd(at);
    m_open.push_back({end, layout.value_or(inherited)});
}

void JsonWriter::openObject(std::string_view key, std::optional<JsonLayout> layout) { open(key, '{', '}', layout); }

void JsonWriter::openArray(std::string_view key, std::optional<JsonLayout> layout) { open(key, '[', ']', layout); }

void JsonWriter::close() {
    const Container container = m_open.back();
    m_open.pop_back();
    char* at = m_text.reserve(2 + 2 * m_open.size());
    if (container.layout == JsonLayout::Indented && !container.isEmpty) at = startLine(at);
    *at++ = container.end;
    m_text.setEnd(at);
}

void JsonWriter::null(std::string_view key) { m_text.setEnd(copied("null", place(key, 4))); }

void JsonWriter::boolean(std::string_view key, bool value) {
    m_text.setEnd(copied(value ? "true" : "false", place(key, 5)));
}

void JsonWriter::number(std::string_view key, std::optional<double> value) { value ? number(key, *value) : null(key); }

void JsonWriter::wholeNumber(std::string_view key, std::optional<std::uint32_t> value) {
    value ? wholeNumber(key, std::uint64_t{*value}) : null(key);
}

void JsonWriter::text(std::string_view key, std::string_view value) {
    m_text.setEnd(place(key, 0));
    if (std::ranges::any_of(value, needsEscape)) {
        std::string escaped;
        appendJsonText(escaped, value);
        m_text.append(escaped);
        return;
    }
    m_text.append('"');
    m_text.append(value);
    m_text.append('"');
}

/// Writes an array of numbers on one line: faster than as elements one by one.
template <class Values, class Write>
void JsonWriter::writeArray(std::string_view key, const Values& values, Write write) {
    constexpr std::size_t kMaxElement = 2 + kMaxNumberLength;  // ", " and the number
    constexpr std::size_t kRun = 64;                           // elements written without asking for more room
    const bool hasSpaces = !isCompact();
    char* at = place(key, 2 + kMaxElement * std::min(kRun, values.size()));
    *at++ = '[';
    std::size_t count = 0;
    for (const auto value : values) {
        if (count > 0) {
            *at++ = ',';
            if (hasSpaces) *at++ = ' ';
        }
        if (++count % kRun == 0) {
            m_text.setEnd(at);
            at = m_text.reserve(2 + kMaxElement * kRun);
        }
        at = write(at, value);
    }
    *at++ = ']';
    m_text.setEnd(at);
}

void JsonWriter::numbers(std::string_view key, std::span<const double> values) {
    const bool hasNegativeZero = !isCompact();
    writeArray(key, values, [&](char* at, double value) { return writeValue(at, value, hasNegativeZero); });
}

void JsonWriter::numbers(std::string_view key, std::initializer_list<double> values) {
    numbers(key, std::span(values.begin(), values.size()));
}

void JsonWriter::wholeNumbers(std::string_view key, std::span<const std::uint32_t> values) {
    writeArray(key, values, [](char* at, std::uint32_t value) { return writeInteger(at, value); });
}

void JsonWriter::points(std::string_view key, std::span<const Vec2> points) {
    rows(key, points, [](Vec2 point) { return std::array{point.x, point.y}; });
}

void JsonWriter::elements(std::string_view array) {
    RUBBLE_ASSERT(array.size() >= 2 && array.front() == '[' && array.back() == ']');
    const std::string_view written = array.substr(1, array.size() - 2);
    if (written.empty()) return;
    Container& container = m_open.back();
    RUBBLE_ASSERT(container.end == ']' && container.layout >= JsonLayout::Compact);
    if (!container.isEmpty) m_text.append(',');
    container.isEmpty = false;
    m_text.append(written);
}

std::string JsonWriter::contents() && {
    RUBBLE_ASSERT(m_open.empty());
    return std::move(m_text).text();
}

std::string JsonWriter::finished() && {
    m_text.append('\n');
    return std::move(*this).contents();
}

}  // namespace rubble
