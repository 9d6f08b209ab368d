#pragma once

#include "core/base/Result.h"
#include "core/geometry/predicates/Vec.h"

#include <algorithm>
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

/// The maximum size of a JSON text that is read, in bytes, and the maximum number of its values. The document of the
/// largest text takes about 1 GiB of memory. A project with a surface of a million triangles has 24 million values.
inline constexpr std::size_t kMaxJsonSize = std::size_t{256} << 20;
inline constexpr std::size_t kMaxJsonValues = std::size_t{32} << 20;

/// Whether a JSON text that was written can be read again.
///
/// Errors: Limit, as of JsonDocument::parse().
Status checkJsonSize(std::string_view text);

/// The range of a numeric field; stated in its error messages.
struct JsonRange {
    double min = std::numeric_limits<double>::lowest();
    double max = std::numeric_limits<double>::max();
    bool isMinExcluded = false;
};
inline JsonRange anyNumber() { return {}; }
inline JsonRange above(double min) { return {.min = min, .isMinExcluded = true}; }
inline JsonRange atLeast(double min) { return {.min = min}; }
inline JsonRange between(double min, double max) { return {.min = min, .max = max}; }

/// A parsed JSON text and the first error found while reading values from it.
///
/// A reader checks for errors once at the end, not after each value: after the first error every value reads as zero or
/// empty, and firstError() says where and why.
///
///     Result<JsonDocument> document = JsonDocument::parse(text);
///     if (!document) return document.error();
///     const JsonValue prism = document->root();
///     prism.requireObject({"outline", "depth"}, {"holes"});
///     const double depth = prism["depth"].number(above(0.0));
///     if (document->firstError()) return *document->firstError();
class JsonDocument {
public:
    /// Guarantees that the keys of each object are unique, numbers finite and strings valid UTF-8.
    ///
    /// Errors: BadInput, with line and column, if the text is not JSON, or with the path if a key is repeated; Limit if
    /// it is larger than 256 MiB, has more than 32 million values or is nested deeper than 64 levels.
    static Result<JsonDocument> parse(std::string_view text);

    /// The outermost value. All values refer to the document, which must not be moved while they are in use.
    JsonValue root();
    /// The first error: "assets[2].prism.depth: expected a number above 0, found \"two\"."
    const std::optional<Error>& firstError() const { return m_error; }

private:
    friend class JsonValue;
    friend class JsonElements;
    class Builder;
    enum class Kind : std::uint8_t { Null, False, True, Unsigned, Negative, Real, Text, Array, Object };
    /// Nodes are in the order of the text, each container before its children: the children of node i start at i + 1,
    /// and the next sibling of node c is nodes[c].end.
    struct Node {
        std::uint64_t bits = 0;  // of a number, or the offset of a string in m_texts
        std::uint32_t key = 0;   // offset in m_texts
        std::uint32_t end = 0;   // index after the last node of this value
        std::uint32_t count = 0;
        Kind kind = Kind::Null;
    };

    std::string_view textAt(std::uint64_t at) const;
    std::string pathOf(std::uint32_t node) const;
    /// The error "assets[2].prism: <reason>."
    Error errorAt(std::uint32_t node, const std::string& reason) const;
    std::string described(std::uint32_t node) const;

    std::vector<Node> m_nodes;
    std::string m_texts;  // each preceded by its length
    std::optional<Error> m_error;
};

/// A value of a document, which knows its path. Reading it as the wrong type sets the document's error.
class JsonValue {
public:
    /// The path, "assets[2].prism.depth"; "the document" at its root.
    std::string path() const;
    /// False for a missing key.
    bool isPresent() const { return m_node != kAbsent; }
    bool isNull() const;
    bool isObject() const;

    /// Requires an object that has all required keys and no others but the optional ones.
    void requireObject(std::initializer_list<std::string_view> required,
                       std::initializer_list<std::string_view> optional = {}) const;
    void requireObject(std::span<const std::string_view> required,
                       std::span<const std::string_view> optional = {}) const;
    /// Requires an object that has all required keys; others are ignored.
    void requireKeys(std::initializer_list<std::string_view> required) const;
    /// The value of a key; its isPresent() is false if the object does not have the key.
    JsonValue operator[](std::string_view key) const;
    /// The elements of an array, in order.
    JsonElements elements() const;

    bool boolean() const;
    double number(JsonRange range = anyNumber()) const;
    /// A number, or nullopt for null.
    std::optional<double> optionalNumber() const { return isNull() ? std::nullopt : std::optional<double>(number()); }
    /// A whole number; 3.0 and 3e2 are whole, too.
    std::uint32_t index(std::uint32_t min = 0, std::uint32_t max = 0xffffffffu) const;
    std::uint64_t wholeNumber(std::uint64_t min = 0, std::uint64_t max = ~std::uint64_t{0}) const;
    std::string text() const;
    /// The index of the value in `words`; 0 and an error if it is none of them.
    std::size_t oneOf(std::span<const std::string_view> words) const;
    /// An array of exactly `Count` numbers.
    template <std::size_t Count>
    std::array<double, Count> numbers(JsonRange range = anyNumber()) const {
        std::array<double, Count> values{};
        readNumbers(values, range);
        return values;
    }

    /// The elements of an array, each converted by `read`.
    template <class Read>
    auto list(Read read) const;
    /// The value converted by `read`, or nullopt for null.
    template <class Read>
    auto optional(Read read) const;
    /// An array of two numbers; an array of such arrays.
    Vec2 point() const;
    std::vector<Vec2> points() const;

    /// Sets the document's error at this value, if it has none: fail("no such asset") gives "shots[1].asset: no such
    /// asset."
    void fail(const std::string& reason) const;

private:
    friend class JsonDocument;
    friend class JsonElements;
    static constexpr std::uint32_t kAbsent = 0xffffffffu;
    JsonValue(JsonDocument* document, std::uint32_t node) : m_document(document), m_node(node) {}

    const JsonDocument::Node* readable() const;
    void failExpected(const std::string& what) const;
    void readNumbers(std::span<double> values, JsonRange range) const;
    void requireKeys(std::span<const std::string_view> required) const;

    JsonDocument* m_document;
    std::uint32_t m_node;
};

/// The elements of an array, for range-based for loops.
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
auto JsonValue::optional(Read read) const {
    using Value = decltype(std::invoke(read, *this));
    return isNull() ? std::nullopt : std::optional<Value>(std::invoke(read, *this));
}

template <class Read>
auto JsonValue::list(Read read) const {
    std::vector<decltype(std::invoke(read, *this))> list;
    constexpr std::uint32_t kMaxReserved = 4096;  // an invalid list ends at its first element
    list.reserve(std::min(elements().size(), kMaxReserved));
    for (const JsonValue element : elements()) {
        if (m_document->firstError()) break;
        list.push_back(std::invoke(read, element));
    }
    return list;
}

}  // namespace rubble
