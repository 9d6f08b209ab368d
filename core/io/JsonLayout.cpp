#include "core/io/JsonLayout.h"

#include "core/base/Assert.h"
#include "core/io/JsonText.h"
#include "core/io/NumberText.h"

#include <cmath>
#include <utility>

namespace rubble {

void JsonLayout::startLine() {
    m_text += '\n';
    m_text.append(2 * m_open.size(), ' ');
}

/// Goes to where the next member or element stands and writes its key.
void JsonLayout::place(std::string_view key) {
    if (!m_open.empty()) {
        Container& container = m_open.back();
        RUBBLE_ASSERT(key.empty() == (container.end == ']'));
        if (!container.isEmpty) m_text += ',';
        if (container.lines == JsonLines::Many) {
            startLine();
        } else if (!container.isEmpty) {
            m_text += ' ';
        }
        container.isEmpty = false;
    }
    if (key.empty()) return;
    appendJsonText(m_text, key);
    m_text += ": ";
}

void JsonLayout::open(std::string_view key, char start, char end, JsonLines lines) {
    place(key);
    m_text += start;
    m_open.push_back({end, lines});
}

void JsonLayout::openObject(std::string_view key, JsonLines lines) { open(key, '{', '}', lines); }

void JsonLayout::openArray(std::string_view key, JsonLines lines) { open(key, '[', ']', lines); }

void JsonLayout::close() {
    const Container container = m_open.back();
    m_open.pop_back();
    if (container.lines == JsonLines::Many && !container.isEmpty) startLine();
    m_text += container.end;
}

void JsonLayout::null(std::string_view key) {
    place(key);
    m_text += "null";
}

void JsonLayout::boolean(std::string_view key, bool value) {
    place(key);
    m_text += value ? "true" : "false";
}

void JsonLayout::number(std::string_view key, double value) {
    place(key);
    if (value == 0.0 && std::signbit(value)) {
        m_text += "-0.0";
    } else {
        appendNumber(m_text, value);
    }
}

void JsonLayout::wholeNumber(std::string_view key, std::uint64_t value) {
    place(key);
    m_text += std::to_string(value);
}

void JsonLayout::number(std::string_view key, std::optional<double> value) { value ? number(key, *value) : null(key); }

void JsonLayout::wholeNumber(std::string_view key, std::optional<std::uint32_t> value) {
    value ? wholeNumber(key, std::uint64_t{*value}) : null(key);
}

void JsonLayout::text(std::string_view key, std::string_view value) {
    place(key);
    appendJsonText(m_text, value);
}

void JsonLayout::numbers(std::string_view key, std::span<const double> values) {
    openArray(key, JsonLines::One);
    for (const double value : values) number({}, value);
    close();
}

void JsonLayout::numbers(std::string_view key, std::initializer_list<double> values) {
    numbers(key, std::span(values.begin(), values.size()));
}

void JsonLayout::points(std::string_view key, std::span<const Vec2> points) {
    openArray(key);
    for (const Vec2 point : points) numbers({}, {point.x, point.y});
    close();
}

std::string JsonLayout::finished() && {
    RUBBLE_ASSERT(m_open.empty());
    m_text += '\n';
    return std::move(m_text);
}

}  // namespace rubble
