#pragma once

#include "core/geometry/Polygon.h"

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// How what is opened is laid out.
enum class JsonLines { Many, One };

/// Writes JSON that people read and compare: each member and each element on a line of its own, two spaces a level, but
/// what is opened as JsonLines::One stays on one line. Numbers are the shortest that read back as the same double, the
/// sign of a zero included.
///
///     JsonLayout json;
///     json.openObject();
///     json.text("name", "wall");
///     json.numbers("gravity", {0.0, -9.81, 0.0});
///     json.close();
///     return std::move(json).finished();
///
/// A member of an object is given its key, an element of an array an empty one.
class JsonLayout {
public:
    void openObject(std::string_view key = {}, JsonLines lines = JsonLines::Many);
    void openArray(std::string_view key = {}, JsonLines lines = JsonLines::Many);
    /// Closes what was opened last.
    void close();

    void null(std::string_view key);
    void boolean(std::string_view key, bool value);
    void number(std::string_view key, double value);
    void wholeNumber(std::string_view key, std::uint64_t value);
    void text(std::string_view key, std::string_view value);
    /// A number, or null where there is none.
    void number(std::string_view key, std::optional<double> value);
    void wholeNumber(std::string_view key, std::optional<std::uint32_t> value);
    /// An array of numbers on one line.
    void numbers(std::string_view key, std::initializer_list<double> values);
    void numbers(std::string_view key, std::span<const double> values);
    /// An array of points: one a line.
    void points(std::string_view key, std::span<const Vec2> points);

    /// An array of what `write` writes of each element.
    template <class Element>
    void list(std::string_view key, const std::vector<Element>& elements, void (*write)(JsonLayout&, const Element&)) {
        openArray(key);
        for (const Element& element : elements) write(*this, element);
        close();
    }

    /// The whole text, ended by a line feed; all that was opened is closed.
    std::string finished() &&;

private:
    struct Container {
        char end;
        JsonLines lines;
        bool isEmpty = true;
    };
    void place(std::string_view key);
    void startLine();
    void open(std::string_view key, char start, char end, JsonLines lines);

    std::string m_text;
    std::vector<Container> m_open;  // outermost first
};

}  // namespace rubble
