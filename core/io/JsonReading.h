#pragma once

#include "core/base/Result.h"
#include "core/geometry/Vec.h"

#include <array>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

class JsonValue;
class JsonElements;

/// The longest JSON text that is read, in bytes; a document takes at most 12 times as much.
inline constexpr std::size_t kLargestJson = std::size_t{256} << 20;

/// Which numbers a field takes; said in its messages.
struct NumberRange {
    double min = std::numeric_limits<double>::lowest();
    double max = std::numeric_limits<double>::max();
    bool isMinExcluded = false;
};
inline NumberRange anyNumber() { return {}; }
inline NumberRange above(double min) { return {.min = min, .isMinExcluded = true}; }
inline NumberRange atLeast(double min) { return {.min = min}; }
inline NumberRange between(double min, double max) { return {.min = min, .max = max}; }

/// A parsed JSON text and the first fault that was found while it was read.
///
/// Values are read straight through, without a check after each: from the first fault on everything reads as
/// zero or empty, and fault() says where and why. Whoever reads asks for it once at the end.
///
///     Result<JsonDocument> document = JsonDocument::parse(text);
///     if (!document) return document.error();
///     const JsonValue prism = document->root();
///     prism.requireObject({"outline", "depth"}, {"holes"});
///     const double depth = prism["depth"].number(above(0.0));
///     if (document->fault()) return *document->fault();
class JsonDocument {
public:
    /// Every key of an object is there once; numbers are finite; text is valid UTF-8.
    ///
    /// Errors: BadInput, with line and column, where the text is not JSON, or with the path where a key comes twice;
    /// Limit where it is larger than 256 MiB or nested deeper than 64 levels.
    static Result<JsonDocument> parse(std::string_view text);

    /// The outermost value; it and all below it borrow the document, which must not be moved meanwhile.
    JsonValue root();
    /// The first fault: "assets[2].prism.depth: expected a number above 0, found \"two\"."
    const std::optional<Error>& fault() const { return m_fault; }

private:
    friend class JsonValue;
    friend class JsonElements;
    class Builder;
    enum class Kind : std::uint8_t { Null, False, True, Unsigned, Negative, Real, Text, Array, Object };
    /// Nodes stand in the order of the text, each container before what it holds: the children of node i begin at
    /// i + 1, and the one after child c is nodes[c].end.
    struct Node {
        std::uint64_t bits = 0;  // the number's, or where the text begins in m_texts
        std::uint32_t key = 0;   // where it begins in m_texts
        std::uint32_t end = 0;   // one behind the last node of this value
        std::uint32_t count = 0;
        Kind kind = Kind::Null;
    };

    std::string_view textAt(std::uint64_t at) const;
    std::string pathOf(std::uint32_t node) const;
    /// "assets[2].prism: <reason>."
    Error faultAt(std::uint32_t node, const std::string& reason) const;
    std::string described(std::uint32_t node) const;

    std::vector<Node> m_nodes;
    std::string m_texts;  // each with its length before it
    std::optional<Error> m_fault;
};

/// A place in a document that knows its path. A value that is not what it is read as becomes the document's fault.
class JsonValue {
public:
    /// "assets[2].prism.depth"; "the document" at its root.
    std::string path() const;
    /// False for a key that is not there.
    bool isPresent() const { return m_node != kAbsent; }
    bool isNull() const;
    bool isObject() const;

    /// An object with all the required keys and none but these and the optional ones.
    void requireObject(std::initializer_list<std::string_view> required,
                       std::initializer_list<std::string_view> optional = {}) const;
    void requireObject(std::span<const std::string_view> required,
                       std::span<const std::string_view> optional = {}) const;
    /// The value of a key; not present where the object does not have it.
    JsonValue operator[](std::string_view key) const;
    /// The elements of an array, in order.
    JsonElements elements() const;

    bool boolean() const;
    double number(NumberRange range = anyNumber()) const;
    /// A number, or none for null.
    std::optional<double> numberOrNone() const { return isNull() ? std::nullopt : std::optional<double>(number()); }
    /// A whole number; 3.0 and 3e2 count as whole.
    std::uint32_t index(std::uint32_t min = 0, std::uint32_t max = 0xffffffffu) const;
    std::uint64_t wholeNumber(std::uint64_t min = 0, std::uint64_t max = ~std::uint64_t{0}) const;
    std::string text() const;
    /// Which of the words it is; the first where it is none of them.
    std::size_t oneOf(std::span<const std::string_view> words) const;
    /// An array of exactly so many numbers.
    template <std::size_t Count>
    std::array<double, Count> numbers(NumberRange range = anyNumber()) const {
        std::array<double, Count> values{};
        readNumbers(values, range);
        return values;
    }

    /// The elements of an array, each as `read` gives it.
    template <class Read>
    auto listOf(Read read) const;
    /// What `read` gives of it, or none for null.
    template <class Read>
    auto orNone(Read read) const;
    /// An array of two numbers; of such arrays.
    Vec2 point() const;
    std::vector<Vec2> points() const;

    /// Makes a fault of this place: refuse("names nothing") gives "shots[1].asset: names nothing."
    void refuse(const std::string& reason) const;

private:
    friend class JsonDocument;
    friend class JsonElements;
    static constexpr std::uint32_t kAbsent = 0xffffffffu;
    JsonValue(JsonDocument* document, std::uint32_t node) : m_document(document), m_node(node) {}

    const JsonDocument::Node* readable() const;
    void expected(const std::string& what) const;
    void readNumbers(std::span<double> values, NumberRange range) const;

    JsonDocument* m_document;
    std::uint32_t m_node;
};

/// The elements of an array, for a range-for.
class JsonElements {
public:
    class Iterator {
    public:
        JsonValue operator*() const { return {m_document, m_node}; }
        Iterator& operator++();
        bool operator==(const Iterator&) const = default;

    private:
        friend class JsonElements;
        Iterator(JsonDocument* document, std::uint32_t node) : m_document(document), m_node(node) {}
        JsonDocument* m_document;
        std::uint32_t m_node;
    };

    std::uint32_t size() const { return m_count; }
    Iterator begin() const { return {m_document, m_first}; }
    Iterator end() const { return {m_document, m_end}; }

private:
    friend class JsonValue;
    JsonElements(JsonDocument* document, std::uint32_t first, std::uint32_t end, std::uint32_t count)
        : m_document(document), m_first(first), m_end(end), m_count(count) {}
    JsonDocument* m_document;
    std::uint32_t m_first;
    std::uint32_t m_end;
    std::uint32_t m_count;
};

template <class Read>
auto JsonValue::orNone(Read read) const {
    using Value = decltype(std::invoke(read, *this));
    return isNull() ? std::nullopt : std::optional<Value>(std::invoke(read, *this));
}

template <class Read>
auto JsonValue::listOf(Read read) const {
    std::vector<decltype(std::invoke(read, *this))> list;
    list.reserve(elements().size());
    for (const JsonValue element : elements()) list.push_back(std::invoke(read, element));
    return list;
}

}  // namespace rubble
