#pragma once

#include "core/base/Assert.h"
#include "core/geometry/polygon/Polygon.h"
#include "core/io/text/NumberTextCache.h"
#include "core/io/text/TextBuffer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// The white space in an object or an array.
enum class JsonLayout {
    Indented,      // each member and element on its own line, indented by two spaces a level
    Inline,        // {"a": 1, "b": 2}
    Compact,       // {"a":1,"b":2}
    CompactLines,  // as Compact, with a line feed between members, and before each element
};

/// Writes JSON. Numbers are the shortest that read back as the same double; the sign of a zero is kept in the layouts
/// Indented and Inline, and dropped in compact ones. They must be finite; in builds without assertions others are null,
/// so that the text stays JSON.
///
///     JsonWriter json;
///     json.openObject();
///     json.text("name", "wall");
///     json.numbers("gravity", {0.0, -9.81, 0.0});
///     json.close();
///     return std::move(json).finished();
///
/// Members of an object take a key, which must not need escaping; elements of an array take an empty one. Objects and
/// arrays have the layout of their parents unless another is given; those in CompactLines are Compact.
class JsonWriter {
public:
    /// Reserves memory for a text of `expectedSize` bytes.
    explicit JsonWriter(JsonLayout layout = JsonLayout::Indented, std::size_t expectedSize = 0)
        : m_layout(layout), m_text(expectedSize) {}

    void openObject(std::string_view key = {}, std::optional<JsonLayout> layout = {});
    void openArray(std::string_view key = {}, std::optional<JsonLayout> layout = {});
    /// Closes the object or array that was opened last.
    void close();

    void null(std::string_view key);
    void boolean(std::string_view key, bool value);
    void number(std::string_view key, double value) {
        m_text.setEnd(writeValue(place(key, kMaxNumberLength), value, !isCompact()));
    }
    void wholeNumber(std::string_view key, std::uint64_t value) {
        m_text.setEnd(writeInteger(place(key, kMaxNumberLength), value));
    }
    void text(std::string_view key, std::string_view value);
    /// A number, or null for nullopt.
    void number(std::string_view key, std::optional<double> value);
    void wholeNumber(std::string_view key, std::optional<std::uint32_t> value);
    /// An array of numbers on one line.
    void numbers(std::string_view key, std::span<const double> values);
    void numbers(std::string_view key, std::initializer_list<double> values);
    void wholeNumbers(std::string_view key, std::span<const std::uint32_t> values);
    /// An array of arrays of numbers: toArray(row) returns a std::array or a view of doubles or integers.
    template <class Rows, class ToArray>
    void rows(std::string_view key, const Rows& rows, ToArray toArray);
    /// An array of points, each an array of two numbers.
    void points(std::string_view key, std::span<const Vec2> points);

    /// An array whose elements are written by write(json, element).
    template <class Elements, class Write>
    void list(std::string_view key, const Elements& elements, Write write) {
        openArray(key);
        for (const auto& element : elements) write(*this, element);
        close();
    }

    /// The elements of an array that another writer wrote in the same layout.
    void elements(std::string_view array);

    /// The text, without and with a line feed at its end. All objects and arrays must be closed.
    std::string contents() &&;
    std::string finished() &&;

private:
    struct Container {
        char end;
        JsonLayout layout;
        bool isEmpty = true;
    };
    static constexpr std::size_t kMaxPunctuation = 8;  // separator, line feed, quotes and colon

    JsonLayout layout() const { return m_open.empty() ? m_layout : m_open.back().layout; }
    static char* copied(std::string_view text, char* at) {
        std::memcpy(at, text.data(), text.size());
        return at + text.size();
    }
    bool isCompact() const { return layout() >= JsonLayout::Compact; }
    static char* writeKey(std::string_view key, char* at) {
        *at++ = '"';
        at = copied(key, at);
        *at++ = '"';
        *at++ = ':';
        return at;
    }
    /// Writes the separator before the next member or element, and its key. Returns where to write `size` more bytes;
    /// the caller sets the end of the text. A local pointer stays in a register, which the buffer's end would not.
    char* place(std::string_view key, std::size_t size) {
        if (m_open.empty() || m_open.back().layout != JsonLayout::Compact) return placeOnLine(key, size);
        Container& container = m_open.back();
        RUBBLE_ASSERT(key.empty() == (container.end == ']'));
        char* at = m_text.reserve(kMaxPunctuation + key.size() + size);
        if (!container.isEmpty) *at++ = ',';
        container.isEmpty = false;
        return key.empty() ? at : writeKey(key, at);
    }
    char* placeOnLine(std::string_view key, std::size_t size);
    char* startLine(char* at) const;
    void open(std::string_view key, char start, char end, std::optional<JsonLayout> layout);
    char* writeValue(char* at, double value, bool hasNegativeZero) {
        RUBBLE_ASSERT(std::isfinite(value));
        if (!std::isfinite(value)) return copied("null", at);
        if (hasNegativeZero && value == 0.0 && std::signbit(value)) return copied("-0.0", at);
        return m_numbers.write(at, value);
    }
    static char* writeValue(char* at, std::int64_t value, bool /*hasNegativeZero*/) {
        if (value < 0) *at++ = '-';
        return writeInteger(at, static_cast<std::uint64_t>(value < 0 ? -value : value));
    }
    template <class Values, class Write>
    void writeArray(std::string_view key, const Values& values, Write write);

    JsonLayout m_layout;  // of the outermost value
    TextBuffer m_text;
    NumberTextCache m_numbers;
    std::vector<Container> m_open;  // outermost first
};

template <class Rows, class ToArray>
void JsonWriter::rows(std::string_view key, const Rows& rows, ToArray toArray) {
    openArray(key);
    const bool hasSpaces = !isCompact();
    const bool isDense = layout() == JsonLayout::Compact;  // the common case in large files
    bool isFirst = true;
    constexpr std::size_t kMaxElement = 2 + kMaxNumberLength;  // ", " and the number
    constexpr std::size_t kRun = 64;                           // numbers written without asking for more room
    for (const auto& row : rows) {
        const auto values = toArray(row);
        const std::size_t size = 3 + kMaxElement * std::min<std::size_t>(kRun, values.size());
        char* at = isDense ? m_text.reserve(size) : place({}, size);
        if (isDense && !isFirst) *at++ = ',';
        isFirst = false;
        *at++ = '[';
        for (std::size_t k = 0; k < values.size(); ++k) {
            if (k > 0 && k % kRun == 0) {
                m_text.setEnd(at);
                at = m_text.reserve(1 + kMaxElement * kRun);
            }
            if (k > 0) *at++ = ',';
            if (k > 0 && hasSpaces) *at++ = ' ';
            at = writeValue(at, values[k], hasSpaces);
        }
        *at++ = ']';
        m_text.setEnd(at);
    }
    close();
}

}  // namespace rubble
