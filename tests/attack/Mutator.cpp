#include "tests/attack/Mutator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace rubble::attack {
namespace {

using Kind = JsonTree::Kind;

template <class List>
const auto& oneOf(const List& list, Random& random) {
    return list[random.below(std::size(list))];
}

bool isOneIn(std::uint64_t count, Random& random) { return random.below(count) == 0; }

constexpr std::array kNumbers = {"0",
                                 "-0",
                                 "-0.0",
                                 "1",
                                 "-1",
                                 "2",
                                 "3",
                                 "0.5",
                                 "5e-324",
                                 "1e-308",
                                 "1e-60",
                                 "1e-45",
                                 "1e-12",
                                 "1e-9",
                                 "1e-6",
                                 "1e-3",
                                 "0.1",
                                 "63",
                                 "64",
                                 "65",
                                 "1000",
                                 "1e5",
                                 "1e6",
                                 "-1e6",
                                 "1e7",
                                 "-1e7",
                                 "1e9",
                                 "1e12",
                                 "1e15",
                                 "1e20",
                                 "1e38",
                                 "1e39",
                                 "-1e39",
                                 "1e100",
                                 "1e300",
                                 "1.7976931348623157e308",
                                 "-1.7976931348623157e308",
                                 "127",
                                 "255",
                                 "65535",
                                 "65536",
                                 "2147483647",
                                 "-2147483648",
                                 "4294967295",
                                 "4294967296",
                                 "9007199254740993",
                                 "9223372036854775807",
                                 "-9223372036854775808",
                                 "18446744073709551615",
                                 "18446744073709551616",
                                 "3.0",
                                 "3e0"};
constexpr std::array kNoNumbers = {"NaN",  "nan", "Infinity", "-Infinity", "inf", "1e999", "-1e999",
                                   "0x10", "01",  "+1",       ".5",        "1.",  "1e",    "--1",
                                   "1e+",  "1,5", "\"1\"",    "1 2",       "-",   "1e-999"};
const std::array<std::string, 19> kTexts = {"\"\"",
                                            "\" \"",
                                            "\"\\u0000\"",
                                            "\"a\\u0000b\"",
                                            "\"\\u001b[31m\"",
                                            "\"\\n\\r\\t\"",
                                            "\"\\ud800\"",
                                            "\"\\udc00\\ud800\"",
                                            "\"\\u202e\"",
                                            "\"../../etc/passwd\"",
                                            "\"/dev/zero\"",
                                            "\"%s%n%x\"",
                                            "\"\x01\x02\"",
                                            "\"\xff\xfe\"",
                                            "\"\xc0\xaf\"",
                                            "\"\xf0\x9f\x98\x80\"",
                                            "\"unclosed",
                                            "\"\\x\"",
                                            "\"a/b\""};

std::string numberText(double value) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.17g", value);
    return text.data();
}

std::string nested(Random& random) {
    const std::size_t depth = oneOf(std::array<std::size_t, 5>{3, 63, 64, 65, 3000}, random);
    std::string text;
    const bool isArray = isOneIn(2, random);
    for (std::size_t k = 0; k < depth; ++k) text += isArray ? "[" : "{\"a\":";
    text += '1';
    text.append(depth, isArray ? ']' : '}');
    return text;
}

JsonTree scalar(std::string text) { return {Kind::Scalar, std::move(text), {}}; }

/// All values below a tree, each with its key.
void collect(JsonTree& tree, const std::string& key, std::vector<std::pair<std::string, JsonTree*>>& places) {
    places.emplace_back(key, &tree);
    for (auto& [childKey, child] : tree.children) collect(child, childKey.empty() ? key : childKey, places);
}

}  // namespace

std::string oddNumber(Random& random) {
    if (isOneIn(8, random)) return oneOf(kNoNumbers, random);
    return oneOf(kNumbers, random);
}

JsonMutator::JsonMutator(const std::vector<std::string>& samples, std::string_view schema) {
    for (const std::string& sample : samples) m_samples.push_back(treeOf(sample));
    for (const JsonTree& sample : m_samples) readValues(sample);
    if (!schema.empty()) readSchema(treeOf(schema));
    for (auto& [key, values] : m_values) {
        std::ranges::sort(values);
        values.erase(std::unique(values.begin(), values.end()), values.end());
        if (values.empty()) values.push_back("1");
        if (!key.empty()) m_keys.push_back(key);
    }
}

/// Collects the values that each key has in the samples.
void JsonMutator::readValues(const JsonTree& tree) {
    for (const auto& [key, child] : tree.children) {
        if (child.kind == Kind::Scalar) m_values[key].push_back(child.text);
        if (child.kind != Kind::Scalar && !key.empty()) m_values[key].push_back(textOf(child).substr(0, 4096));
        readValues(child);
    }
}

/// Collects the keys of a schema with the limits and words that it allows.
void JsonMutator::readSchema(const JsonTree& schema) {
    for (const auto& [name, child] : schema.children) {
        readSchema(child);
        if (name != "\"properties\"") continue;
        for (const auto& [key, property] : child.children) {
            std::vector<std::string>& values = m_values[key];
            for (const auto& [keyword, value] : property.children) {
                const bool isLimit = keyword == "\"minimum\"" || keyword == "\"maximum\"" ||
                                     keyword == "\"exclusiveMinimum\"" || keyword == "\"exclusiveMaximum\"";
                if (isLimit) {
                    const double limit = std::strtod(value.text.c_str(), nullptr);
                    const double step = std::max(1e-9, std::abs(limit) * 1e-9);
                    for (const double near : {limit, limit - step, limit + step, limit - 1, limit + 1, 2 * limit})
                        values.push_back(numberText(near));
                }
                if (keyword == "\"const\"") values.push_back(textOf(value));
                if (keyword == "\"enum\"")
                    for (const auto& word : value.children) values.push_back(textOf(word.second));
            }
        }
    }
}

std::string JsonMutator::newText(const std::string& key, const std::string& old, Random& random) const {
    const auto known = m_values.find(key);
    if (known != m_values.end() && isOneIn(3, random)) return oneOf(known->second, random);
    const bool isText = old.starts_with('"');
    const bool isNumber = !isText && old != "true" && old != "false" && old != "null";
    if (isOneIn(12, random))
        return oneOf(std::array{"null", "true", "false", "[]", "{}", "\"x\"", "7", "[[]]"}, random);
    if (isOneIn(60, random)) return nested(random);
    if (isText) {
        if (isOneIn(16, random))
            return '"' + std::string(oneOf(std::array<std::size_t, 3>{255, 5000, 70000}, random), 'a') + '"';
        if (isOneIn(3, random)) return oneOf(m_values.at(oneOf(m_keys, random)), random);
        return oneOf(kTexts, random);
    }
    if (!isNumber) return old == "true" ? "false" : "true";
    if (isOneIn(2, random)) return oddNumber(random);
    const double value = std::strtod(old.c_str(), nullptr);
    switch (random.below(5)) {
        case 0: return numberText(-value);
        case 1: return numberText(value * std::pow(10.0, random.between(-20.0, 20.0)));
        case 2: return numberText(std::nextafter(value, random.between(-1e9, 1e9)));
        case 3: return numberText(std::trunc(value) + static_cast<double>(random.below(5)) - 2.0);
        default: return numberText(value * random.between(0.5, 2.0));
    }
}

/// Removes, repeats, swaps, adds or renames the members of an object or the elements of an array.
void JsonMutator::changeMembers(JsonTree& tree, Random& random) const {
    const bool isObject = tree.kind == Kind::Object;
    const auto newKey = [&] {
        return isOneIn(20, random) ? std::string(oneOf(kTexts, random)) : oneOf(m_keys, random);
    };
    auto& members = tree.children;
    if (members.empty() || isOneIn(8, random)) {
        const std::string key = isObject ? newKey() : std::string();
        members.emplace_back(key, scalar(newText(key, oneOf(kNumbers, random), random)));
        return;
    }
    const std::size_t at = random.below(members.size());
    const auto place = members.begin() + static_cast<std::ptrdiff_t>(at);
    switch (random.below(isObject ? 6 : 5)) {
        case 0: members.erase(place); break;
        case 1: members.push_back(members[at]); break;
        case 2: std::swap(members[at], members[random.below(members.size())]); break;
        case 3: {
            const auto copy = members[at];
            const std::size_t times = isObject ? 1 : oneOf(std::array<std::size_t, 4>{1, 2, 10, 100}, random);
            if (textOf(copy.second).size() * times < 100000) members.insert(place, times, copy);
            break;
        }
        case 4: members.clear(); break;
        default: members[at].first = newKey(); break;
    }
}

void JsonMutator::change(JsonTree& document, Random& random) const {
    std::vector<std::pair<std::string, JsonTree*>> places;
    collect(document, "", places);
    const auto& [key, tree] = places[random.below(places.size())];
    if (isOneIn(24, random)) {  // any other value of the document
        JsonTree copy = *places[random.below(places.size())].second;
        *tree = std::move(copy);
    } else if (tree->kind == Kind::Scalar) {
        tree->text = newText(key, tree->text, random);
    } else if (isOneIn(16, random)) {
        *tree = scalar(newText(key, "1", random));
    } else {
        changeMembers(*tree, random);
    }
}

std::string JsonMutator::mutated(Random& random) const {
    JsonTree document = oneOf(m_samples, random);
    const bool isAsBytes = isOneIn(8, random);
    for (std::uint64_t changes = isAsBytes ? 0 : 1 + random.below(4); changes > 0; --changes) change(document, random);
    return isAsBytes ? mutatedBytes(textOf(document), random) : textOf(document);
}

std::string mutatedBytes(std::string bytes, Random& random) {
    for (std::uint64_t changes = 1 + random.below(4); changes > 0; --changes) {
        if (bytes.empty()) bytes = "0";
        const std::size_t at = random.below(bytes.size());
        const std::size_t length = std::min<std::size_t>(bytes.size() - at, 1 + random.below(16));
        switch (random.below(10)) {
            case 0:
            case 1:
            case 2: bytes[at] = static_cast<char>(bytes[at] ^ (1 << random.below(8))); break;
            case 3: bytes[at] = static_cast<char>(random.below(256)); break;
            case 4: bytes.erase(at, length); break;
            case 5: bytes.insert(at, bytes.substr(at, length)); break;
            case 6: bytes.resize(at); break;
            case 7:
                bytes +=
                    oneOf(std::array<std::string, 5>{std::string(1, '\0'), "x", "{}", "\xef\xbb\xbf", " "}, random);
                break;
            case 8: {  // a whole number of four bytes
                const auto value =
                    oneOf(std::array<std::uint32_t, 6>{0, 1, 0x7fffffff, 0x80000000, 0xffffffff, 0x10000}, random);
                std::memcpy(bytes.data() + at, &value, std::min<std::size_t>(sizeof value, bytes.size() - at));
                break;
            }
            default:
                bytes.insert(at, std::string(length, oneOf(std::array{'\0', '[', '"', '9', '\xff'}, random)));
                break;
        }
    }
    return bytes;
}

std::string mutatedLines(const std::string& text, Random& random) {
    std::vector<std::string> lines(1);
    for (const char letter : text) letter == '\n' ? lines.emplace_back().size() : (lines.back() += letter).size();
    for (std::uint64_t changes = 1 + random.below(4); changes > 0 && !lines.empty(); --changes) {
        const std::size_t at = random.below(lines.size());
        std::string& line = lines[at];
        const auto place = lines.begin() + static_cast<std::ptrdiff_t>(at);
        switch (random.below(8)) {
            case 0: lines.erase(place); break;
            case 1: lines.insert(place, lines[random.below(lines.size())]); break;
            case 2: std::swap(line, lines[random.below(lines.size())]); break;
            case 3: line += ' ' + oddNumber(random); break;
            case 4: line = mutatedBytes(line, random); break;
            default: {  // another word in place of one
                const std::size_t start = line.empty() ? 0 : random.below(line.size());
                const std::size_t from = line.find_last_of(" \t/=\"", start) + 1;
                const std::size_t to = std::min(line.find_first_of(" \t/=\"", start), line.size());
                if (from <= to) line.replace(from, to - from, oddNumber(random));
                break;
            }
        }
    }
    std::string result;
    for (const std::string& line : lines) (result += line) += '\n';
    return result;
}

}  // namespace rubble::attack
