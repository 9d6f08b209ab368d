#include "core/io/json/JsonDocument.h"

#include "core/base/MessageText.h"
#include "core/io/text/NumberText.h"

#include <algorithm>
#include <bit>

namespace rubble {
namespace {

bool isPlainKey(std::string_view key) {
    const auto isPlain = [](char letter) {
        return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
               (letter >= '0' && letter <= '9') || letter == '_';
    };
    return !key.empty() && key.size() <= 40 && std::ranges::all_of(key, isPlain);
}

std::string rangeText(JsonRange range) {
    const JsonRange any;
    if (range.isMinExcluded) return "a number above " + numberText(range.min);
    if (range.max < any.max) return "a number from " + numberText(range.min) + " to " + numberText(range.max);
    return range.min > any.min ? "a number of at least " + numberText(range.min) : "a number";
}

std::string wordList(std::span<const std::string_view> words) {
    std::string list;
    for (std::size_t i = 0; i < words.size(); ++i)
        list += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + quotedName(words[i]);
    return list;
}

}  // namespace

std::string JsonDocument::pathOf(std::uint32_t node) const {
    if (node == 0) return "the document";
    std::string path;
    std::uint32_t container = 0;
    while (container != node) {
        std::uint32_t child = container + 1;
        std::uint32_t number = 0;
        for (; m_nodes[child].end <= node; child = m_nodes[child].end) ++number;
        const std::string_view key = m_nodes[container].kind == Kind::Object ? textAt(m_nodes[child].key) : "";
        if (m_nodes[container].kind == Kind::Array) {
            path += "[" + std::to_string(number) + "]";
        } else if (isPlainKey(key)) {
            path.append(path.empty() ? "" : ".").append(key);
        } else {
            path += "[" + quotedName(key) + "]";
        }
        container = child;
    }
    return path;
}

Error JsonDocument::errorAt(std::uint32_t node, const std::string& reason) const {
    std::string message = pathOf(node) + ": " + reason + ".";
    if (node == 0) message[0] = 'T';
    return {ErrorCode::BadInput, std::move(message)};
}

std::string JsonDocument::described(std::uint32_t index) const {
    const Node& node = m_nodes[index];
    switch (node.kind) {
        case Kind::Null: return "null";
        case Kind::False: return "false";
        case Kind::True: return "true";
        case Kind::Unsigned: return std::to_string(node.bits);
        case Kind::Negative: return std::to_string(std::bit_cast<std::int64_t>(node.bits));
        case Kind::Real: return numberText(std::bit_cast<double>(node.bits));
        case Kind::Text: return quotedName(textAt(node.bits));
        case Kind::Array: return "an array of " + std::to_string(node.count);
        case Kind::Object: return "an object";
    }
    return {};
}

std::string JsonValue::path() const { return isPresent() ? m_document->pathOf(m_node) : std::string(); }

bool JsonValue::isNull() const { return isPresent() && m_document->m_nodes[m_node].kind == JsonDocument::Kind::Null; }

bool JsonValue::isObject() const {
    return isPresent() && m_document->m_nodes[m_node].kind == JsonDocument::Kind::Object;
}

/// Returns the node, or null after an error.
const JsonDocument::Node* JsonValue::readable() const {
    if (m_document->m_error) return nullptr;
    RUBBLE_ASSERT(isPresent());
    return &m_document->m_nodes[m_node];
}

void JsonValue::fail(const std::string& reason) const {
    if (!m_document->m_error) m_document->m_error = m_document->errorAt(m_node, reason);
}

void JsonValue::failExpected(const std::string& what) const {
    fail("expected " + what + ", found " + m_document->described(m_node));
}

void JsonValue::requireObject(std::initializer_list<std::string_view> required,
                              std::initializer_list<std::string_view> optional) const {
    requireObject(std::span(required.begin(), required.size()), std::span(optional.begin(), optional.size()));
}

void JsonValue::requireObject(std::span<const std::string_view> required,
                              std::span<const std::string_view> optional) const {
    const JsonDocument::Node* node = readable();
    if (!node) return;
    if (node->kind != JsonDocument::Kind::Object) return failExpected("an object");
    const auto& nodes = m_document->m_nodes;
    for (std::uint32_t child = m_node + 1; child < node->end; child = nodes[child].end) {
        const std::string_view key = m_document->textAt(nodes[child].key);
        if (std::ranges::find(required, key) == required.end() && std::ranges::find(optional, key) == optional.end())
            return fail("unknown key " + quotedName(key));
    }
    requireKeys(required);
}

void JsonValue::requireKeys(std::initializer_list<std::string_view> required) const {
    requireKeys(std::span(required.begin(), required.size()));
}

void JsonValue::requireKeys(std::span<const std::string_view> required) const {
    const JsonDocument::Node* node = readable();
    if (!node) return;
    if (node->kind != JsonDocument::Kind::Object) return failExpected("an object");
    for (const std::string_view key : required)
        if (!(*this)[key].isPresent()) return fail("the key " + quotedName(key) + " is missing");
}

JsonValue JsonValue::operator[](std::string_view key) const {
    const JsonDocument::Node* node = readable();
    if (!node || node->kind != JsonDocument::Kind::Object) return {m_document, kAbsent};
    const auto& nodes = m_document->m_nodes;
    for (std::uint32_t child = m_node + 1; child < node->end; child = nodes[child].end)
        if (m_document->textAt(nodes[child].key) == key) return {m_document, child};
    return {m_document, kAbsent};
}

JsonElements JsonValue::elements() const {
    const JsonDocument::Node* node = readable();
    if (node && node->kind == JsonDocument::Kind::Array) return {m_document, m_node + 1, node->end, node->count};
    if (node) failExpected("an array");
    return {m_document, 0, 0, 0};
}

bool JsonValue::boolean() const {
    const JsonDocument::Node* node = readable();
    if (!node) return false;
    if (node->kind != JsonDocument::Kind::True && node->kind != JsonDocument::Kind::False)
        failExpected("true or false");
    return node->kind == JsonDocument::Kind::True;
}

double JsonValue::number(JsonRange range) const {
    const JsonDocument::Node* node = readable();
    if (!node) return 0.0;
    double value = std::numeric_limits<double>::quiet_NaN();
    if (node->kind == JsonDocument::Kind::Real) value = std::bit_cast<double>(node->bits);
    if (node->kind == JsonDocument::Kind::Unsigned) value = static_cast<double>(node->bits);
    if (node->kind == JsonDocument::Kind::Negative)
        value = static_cast<double>(std::bit_cast<std::int64_t>(node->bits));
    if (value >= range.min && value <= range.max && !(range.isMinExcluded && value == range.min)) return value;
    failExpected(rangeText(range));
    return 0.0;
}

std::uint64_t JsonValue::wholeNumber(std::uint64_t min, std::uint64_t max) const {
    constexpr double kBeyond = 18446744073709551616.0;  // 2^64
    const JsonDocument::Node* node = readable();
    if (!node) return 0;
    bool isWhole = node->kind == JsonDocument::Kind::Unsigned;
    std::uint64_t value = isWhole ? node->bits : 0;
    if (node->kind == JsonDocument::Kind::Real) {
        const auto real = std::bit_cast<double>(node->bits);
        isWhole = real >= 0.0 && real < kBeyond && real == static_cast<double>(static_cast<std::uint64_t>(real));
        if (isWhole) value = static_cast<std::uint64_t>(real);
    }
    if (isWhole && value >= min && value <= max) return value;
    failExpected("a whole number from " + std::to_string(min) + " to " + std::to_string(max));
    return 0;
}

std::uint32_t JsonValue::index(std::uint32_t min, std::uint32_t max) const {
    return static_cast<std::uint32_t>(wholeNumber(min, max));
}

std::string JsonValue::text() const {
    const JsonDocument::Node* node = readable();
    if (!node) return {};
    if (node->kind == JsonDocument::Kind::Text) return std::string(m_document->textAt(node->bits));
    failExpected("a text");
    return {};
}

std::size_t JsonValue::oneOf(std::span<const std::string_view> words) const {
    const JsonDocument::Node* node = readable();
    if (!node) return 0;
    if (node->kind == JsonDocument::Kind::Text) {
        const auto found = std::ranges::find(words, m_document->textAt(node->bits));
        if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    }
    failExpected(wordList(words));
    return 0;
}

void JsonValue::readNumbers(std::span<double> values, JsonRange range) const {
    const JsonDocument::Node* node = readable();
    if (!node) return;
    if (node->kind != JsonDocument::Kind::Array || node->count != values.size())
        return failExpected("an array of " + std::to_string(values.size()) + " numbers");
    std::size_t next = 0;
    for (const JsonValue element : elements()) values[next++] = element.number(range);
}

Vec2 JsonValue::point() const {
    const auto [x, y] = numbers<2>();
    return {x, y};
}

std::vector<Vec2> JsonValue::points() const { return list(&JsonValue::point); }

JsonElements::Iterator& JsonElements::Iterator::operator++() {
    m_node = m_document->m_nodes[m_node].end;
    return *this;
}

}  // namespace rubble
