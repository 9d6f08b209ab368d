#include "tests/attack/FbxMutator.h"

#include "tests/attack/Mutator.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace rubble::attack {
namespace {

constexpr std::string_view kMagic("Kaydara FBX Binary  \0\x1a\0", 23);
constexpr std::size_t kHeader = 27;
constexpr std::uint32_t kWideVersion = 7500;  // from here on sizes have eight bytes

std::uint64_t numberAt(const std::string& bytes, std::size_t at, std::size_t size) {
    std::uint64_t number = 0;
    std::memcpy(&number, bytes.data() + at, size);
    return number;
}

std::string numberBytes(std::uint64_t number, std::size_t size) {
    std::string bytes(size, '\0');
    std::memcpy(bytes.data(), &number, size);
    return bytes;
}

std::size_t sizeWidth(const std::string& header) { return numberAt(header, 23, 4) < kWideVersion ? 4 : 8; }

/// The size of a number of this type, and of an element of an array of this type; 0 for other types.
std::size_t elementSize(char type) {
    switch (type) {
        case 'C':
        case 'b': return 1;
        case 'Y': return 2;
        case 'I':
        case 'F':
        case 'i':
        case 'f': return 4;
        case 'L':
        case 'D':
        case 'l':
        case 'd': return 8;
        default: return 0;
    }
}

bool isArray(char type) { return type >= 'a' && elementSize(type) > 0; }

/// Reads the nodes of a file; every place is checked against its end.
class FbxReader {
public:
    FbxReader(const std::string& bytes, std::size_t width) : m_bytes(bytes), m_width(width) {}

    /// Reads nodes up to the empty one that ends a list.
    std::optional<std::vector<FbxNode>> nodes() {
        std::vector<FbxNode> list;
        for (;;) {
            const std::size_t start = m_at;
            const std::size_t end = number(m_width);
            const std::size_t count = number(m_width);
            const std::size_t size = number(m_width);
            const std::string name = text(number(1));
            if (end == 0) return m_hasFailed ? std::nullopt : std::optional(std::move(list));
            if (m_hasFailed || end <= start || size > m_bytes.size()) return std::nullopt;
            FbxNode node{.name = name};
            const std::size_t children = m_at + size;
            for (std::size_t k = 0; k < count && !m_hasFailed; ++k) node.properties.push_back(property());
            if (m_hasFailed || m_at != children) return std::nullopt;
            if (m_at < end) {
                auto below = nodes();
                if (!below) return std::nullopt;
                node.children = std::move(*below);
            }
            if (m_at != end) return std::nullopt;
            list.push_back(std::move(node));
        }
    }
    std::size_t position() const { return m_at; }
    void skip(std::size_t count) { text(count); }

private:
    std::string text(std::size_t count) {
        if (count > m_bytes.size() - m_at) {
            m_hasFailed = true;
            return {};
        }
        m_at += count;
        return m_bytes.substr(m_at - count, count);
    }
    std::size_t number(std::size_t size) {
        const std::string bytes = text(size);
        return m_hasFailed ? 0 : numberAt(bytes, 0, size);
    }
    std::string property() {
        const std::size_t start = m_at;
        const char type = static_cast<char>(number(1));
        if (isArray(type)) {
            skip(8);
            skip(number(4));
        } else if (elementSize(type) > 0) {
            skip(elementSize(type));
        } else {
            m_hasFailed = m_hasFailed || (type != 'S' && type != 'R');
            skip(number(4));
        }
        return m_bytes.substr(start, m_at - start);
    }

    const std::string& m_bytes;
    std::size_t m_width;
    std::size_t m_at = 0;
    bool m_hasFailed = false;
};

void append(const FbxNode& node, std::size_t width, std::string& bytes) {
    const std::size_t start = bytes.size();
    bytes.append(3 * width, '\0');
    const std::string name = node.name.substr(0, 255);
    bytes += static_cast<char>(name.size());
    bytes += name;
    const std::size_t properties = bytes.size();
    for (const std::string& property : node.properties) bytes += property;
    const std::size_t size = bytes.size() - properties;
    for (const FbxNode& child : node.children) append(child, width, bytes);
    if (!node.children.empty() || node.properties.empty()) bytes.append(3 * width + 1, '\0');
    bytes.replace(
        start, 3 * width,
        numberBytes(bytes.size(), width) + numberBytes(node.properties.size(), width) + numberBytes(size, width));
}

template <class List>
const auto& anyOf(const List& list, Random& random) {
    return list[random.below(std::size(list))];
}

/// The bytes of a number or of an element of an array.
std::string oddValue(char type, Random& random) {
    const std::size_t size = elementSize(type);
    const double value = std::strtod(oddNumber(random).c_str(), nullptr);
    if (type == 'D' || type == 'd') return std::string(reinterpret_cast<const char*>(&value), size);
    if (type == 'F' || type == 'f') {
        const auto single = static_cast<float>(std::clamp(value, -3e38, 3e38));
        return std::string(reinterpret_cast<const char*>(&single), size);
    }
    constexpr std::array<std::uint64_t, 14> kIntegers = {0,
                                                         1,
                                                         2,
                                                         3,
                                                         7,
                                                         8,
                                                         ~std::uint64_t{0},
                                                         ~std::uint64_t{1},
                                                         ~std::uint64_t{8},
                                                         0x7fffffff,
                                                         0x80000000,
                                                         0xffffffff,
                                                         0x7fffffffffffffff,
                                                         0x8000000000000000};
    return numberBytes(anyOf(kIntegers, random), size);
}

std::string oddArray(const std::string& old, Random& random) {
    const auto count = static_cast<std::uint32_t>(numberAt(old, 1, 4));
    if (random.below(3) == 0) {  // a size or an encoding that the data do not have
        std::string array = old;
        const auto size = anyOf(
            std::array<std::uint32_t, 8>{0, 1, 2, count - 1, count + 1, 0x7fffffff, 0xffffffff, 0x10000000}, random);
        return array.replace(1 + 4 * random.below(3), 4, numberBytes(size, 4));
    }
    const std::uint32_t size =
        anyOf(std::array<std::uint32_t, 8>{0, 1, 2, 3, count, count, count + 1, 1000}, random) % 100000;
    std::string values;
    for (std::uint32_t k = 0; k < size; ++k)
        values += random.below(4) == 0 ? oddValue(old[0], random) : numberBytes(k % 8, elementSize(old[0]));
    return old[0] + numberBytes(size, 4) + numberBytes(0, 4) + numberBytes(values.size(), 4) + values;
}

std::string oddProperty(const std::string& old, const std::vector<std::string>& known, Random& random) {
    if (random.below(3) == 0) return anyOf(known, random);
    if (isArray(old[0])) return oddArray(old, random);
    if (elementSize(old[0]) > 0) return old[0] + oddValue(old[0], random);
    const std::size_t length = anyOf(std::array<std::size_t, 5>{0, 1, 255, 1023, 70000}, random);
    const std::string text = random.below(2) == 0 ? mutatedBytes(old.substr(5), random) : std::string(length, 'a');
    return old[0] + numberBytes(text.size(), 4) + text;
}

void listNodes(std::vector<FbxNode>& nodes, std::vector<FbxNode*>& list) {
    for (FbxNode& node : nodes) {
        list.push_back(&node);
        listNodes(node.children, list);
    }
}

/// Removes, repeats or swaps elements of a list.
template <class Element>
void changeList(std::vector<Element>& list, Random& random) {
    if (list.empty()) return;
    const std::size_t at = random.below(list.size());
    switch (random.below(3)) {
        case 0: list.erase(list.begin() + static_cast<std::ptrdiff_t>(at)); break;
        case 1: list.push_back(Element(list[at])); break;
        default: std::swap(list[at], list[random.below(list.size())]); break;
    }
}

void nest(FbxNode& node, Random& random) {
    const std::size_t depth = anyOf(std::array<std::size_t, 4>{3, 64, 500, 3000}, random);
    for (std::size_t k = 0; k < depth; ++k) {
        FbxNode outer{.name = node.name};
        outer.children.push_back(std::move(node));
        node = std::move(outer);
    }
}

void change(FbxDocument& document, Random& random) {
    std::vector<FbxNode*> nodes;
    listNodes(document.nodes, nodes);
    if (nodes.empty()) return;
    std::vector<std::string> known;
    for (const FbxNode* node : nodes) known.insert(known.end(), node->properties.begin(), node->properties.end());
    FbxNode& node = *anyOf(nodes, random);
    if (random.below(60) == 0) return nest(node, random);
    switch (random.below(8)) {
        case 0: node.name = anyOf(nodes, random)->name; break;
        case 1: changeList(node.properties, random); break;
        case 2: changeList(node.children.empty() ? document.nodes : node.children, random); break;
        case 3: {
            FbxNode copy = *anyOf(nodes, random);
            node.children.push_back(std::move(copy));
            break;
        }
        default:
            if (node.properties.empty()) break;
            std::string& property = node.properties[random.below(node.properties.size())];
            property = oddProperty(property, known, random);
            break;
    }
}

}  // namespace

std::optional<FbxDocument> fbxDocument(const std::string& bytes) {
    if (bytes.size() < kHeader || !bytes.starts_with(kMagic)) return std::nullopt;
    FbxDocument document{.header = bytes.substr(0, kHeader)};
    FbxReader reader(bytes, sizeWidth(document.header));
    reader.skip(kHeader);
    auto nodes = reader.nodes();
    if (!nodes) return std::nullopt;
    document.nodes = std::move(*nodes);
    document.footer = bytes.substr(reader.position());
    return document;
}

std::string fbxBytes(const FbxDocument& document) {
    const std::size_t width = sizeWidth(document.header);
    std::string bytes = document.header;
    for (const FbxNode& node : document.nodes) append(node, width, bytes);
    return bytes.append(3 * width + 1, '\0') + document.footer;
}

FbxDocument mutatedFbx(FbxDocument document, Random& random) {
    for (std::uint64_t changes = 1 + random.below(4); changes > 0; --changes) change(document, random);
    return document;
}

}  // namespace rubble::attack
