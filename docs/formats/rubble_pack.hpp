// rubble_pack.hpp - reads the packs that Rubble exports, and the events that it tells. One header, C++17, the standard
// library only, no exceptions.
//
//     rubble_pack::Pack pack;
//     std::string fault;
//     if (!rubble_pack::load("wall/pack.json", pack, fault)) return fail(fault);
//     for (const rubble_pack::Body& fragment : pack.fragments) addBody(fragment.mass, fragment.hulls, fragment.offset);
//
// The fields are described in pack.md and events.md, beside this file. All indices in a pack that was read are in range
// and need no checks. Metres, kilograms, seconds; right-handed, y up.
//
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the authors of Rubble
//
// Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated
// documentation files (the "Software"), to deal in the Software without restriction, including without limitation the
// rights to use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies of the Software, and to
// permit persons to whom the Software is furnished to do so, subject to the following conditions:
//
// The above copyright notice and this permission notice shall be included in all copies or substantial portions of the
// Software.
//
// THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE
// WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR
// COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR
// OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <initializer_list>
#include <locale>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rubble_pack {

constexpr std::uint32_t kVersion = 1;         // of the packs that this header reads
constexpr std::uint32_t kNone = 0xffffffffu;  // no fragment

struct Vec3 {
    double x = 0.0, y = 0.0, z = 0.0;
};

/// The points p with dot(normal, p) <= offset are inside; the normal has length 1.
struct Plane {
    Vec3 normal;
    double offset = 0.0;  // m
};

/// An edge in the loop of a face: +1 from its first vertex to its second, -1 reversed.
struct SignedEdge {
    std::uint32_t edge = 0;
    int sign = 1;
};

/// A closed convex solid in its body's frame. Step k of a face runs from vertex faces[f][k] to the next of that loop
/// and along signedEdges[f][k]; the first two edges of a loop are never collinear.
struct Hull {
    std::vector<Vec3> vertices;                        // m
    std::vector<std::array<std::uint32_t, 2>> edges;   // each once
    std::vector<std::vector<std::uint32_t>> faces;     // vertices, counter-clockwise from outside
    std::vector<std::vector<SignedEdge>> signedEdges;  // a loop for each face
    std::vector<Plane> planes;                         // one for each face
};

struct Neighbour {
    std::uint32_t fragment = 0;  // index in Pack::fragments
    double area = 0.0;           // m^2, of contact
};

/// The whole or a fragment. Its frame has the axes of the asset and its centre of mass as origin.
struct Body {
    std::string id;
    std::string name;                                // of its object in the meshes
    std::uint32_t parent = kNone;                    // the parent fragment; kNone: the whole
    Vec3 offset;                                     // of its frame in the asset's, m
    double volume = 0.0;                             // m^3
    double mass = 0.0;                               // kg
    Vec3 centreOfMass;                               // in its own frame, m
    std::array<std::array<double, 3>, 3> inertia{};  // kg m^2, about the centre of mass, by rows
    double threshold = 0.0;                          // N·s, its own; 0: see Pack::thresholdOf()
    double gap = 0.0;                                // m between its fragments
    double lostMass = 0.0;                           // kg that the gap takes from them
    std::vector<Neighbour> neighbours;               // ascending
    std::vector<Hull> hulls;                         // at least one
};

struct Material {
    std::string name;
    double density = 0.0;  // kg/m^3
    double friction = 0.0;
    double restitution = 0.0;
    std::array<double, 3> outside{};  // sRGB
    std::array<double, 3> inside{};
};

enum class MeshBodies { Whole, Fragments, Fragment };
enum class MeshPlace { Assembled, Centred };

/// A mesh file beside pack.json.
struct Mesh {
    std::string file;
    MeshBodies bodies = MeshBodies::Fragments;
    std::uint32_t fragment = kNone;  // for MeshBodies::Fragment
    MeshPlace place = MeshPlace::Assembled;
};

struct Pack {
    std::uint32_t asset = 0;
    std::string name;
    std::string hash;        // equal for equal packs
    double threshold = 0.0;  // N·s; an impact at or above it breaks the body
    Material material;
    std::vector<Mesh> meshes;
    Body whole;
    std::vector<Body> fragments;  // parents before their children

    /// The impact that breaks a body, N·s: its own threshold, or one that follows from its volume. `body`: an index in
    /// `fragments`, or kNone: the whole. Only of bodies that break.
    double thresholdOf(std::uint32_t body) const {
        if (body == kNone) return threshold;
        const Body& one = fragments[body];
        return one.threshold > 0.0 ? one.threshold : threshold * std::pow(one.volume / whole.volume, 2.0 / 3.0);
    }
    /// The fragments of a body; kNone: of the whole. Empty if it does not break.
    std::vector<std::uint32_t> piecesOf(std::uint32_t parent) const {
        std::vector<std::uint32_t> pieces;
        for (std::uint32_t k = 0; k < fragments.size(); ++k) {
            if (fragments[k].parent == parent) pieces.push_back(k);
        }
        return pieces;
    }
};

/// Parses a pack.json. On an error returns false, sets `fault` to a message and does not change the pack.
inline bool parse(std::string_view json, Pack& pack, std::string& fault);

/// Reads a file.
inline bool load(const std::string& path, Pack& pack, std::string& fault);

/// The kinds of events, in the order in which a step tells them.
enum class EventKind { Impact, Bonds, Detached, Broken, Settled, Removed };
constexpr std::size_t kEventKinds = 6;

/// Why a body was removed; None: it was not.
enum class RemovalReason { None, Lifetime, Budget, LeftWorld };

struct Box {
    Vec3 min, max;  // m
};

/// Something that happened to a body in a step.
struct Event {
    std::uint64_t step = 0;  // after which it holds
    EventKind kind = EventKind::Impact;
    std::uint32_t body = 0;                    // its number
    std::uint32_t other = kNone;               // of the body that it touched; kNone: none
    std::uint32_t instance = 0;                // id; 0: the ground, or thrown
    std::string fragment;                      // its path in the asset; empty: the whole
    Vec3 point;                                // m, in the world
    Vec3 normal;                               // from `other` into `body`
    double impulse = 0.0;                      // N·s, along the normal
    double speed = 0.0;                        // m/s, of the approach
    double energy = 0.0;                       // J: that both bodies lost, or that the break took
    double area = 0.0;                         // m^2, of the faces that opened
    double mass = 0.0;                         // kg, of what came free, came to rest or is gone
    std::uint32_t count = 0;                   // of fragments that came free
    std::array<std::uint32_t, 2> materials{};  // ids, of both bodies; of the body and its inside. 0: none
    Box box;                                   // of what changed, in the world
    RemovalReason reason = RemovalReason::None;
};

/// Events of a kind that happened and are not told one by one.
struct OmittedEvents {
    std::uint32_t count = 0;
    double energy = 0.0;  // J
};

/// The rest of a step.
struct EventSums {
    std::uint64_t step = 0;
    std::array<OmittedEvents, kEventKinds> omitted{};  // by kind
    double restEnergy = 0.0;                           // J, that contacts took without an impact
};

struct EventLog {
    std::vector<Event> events;    // ascending step
    std::vector<EventSums> sums;  // ascending step
};

/// Parses events as JSON lines. On an error returns false, sets `fault` to a message and does not change the log.
inline bool parseEvents(std::string_view lines, EventLog& log, std::string& fault);

/// Reads a file.
inline bool loadEvents(const std::string& path, EventLog& log, std::string& fault);

namespace detail {

enum class Kind { Null, Boolean, Number, Text, Array, Object };

/// JSON values in the order of their text, each container before what it holds: the first child of node i is i + 1, the
/// one behind a child is at its `end`.
struct Node {
    Kind kind = Kind::Null;
    double number = 0.0;
    std::uint32_t text = 0;   // index in Document::texts
    std::uint32_t key = 0;    // the same, of a member of an object
    std::uint32_t count = 0;  // of children
    std::uint32_t end = 0;
};
struct Document {
    std::vector<Node> nodes;
    std::vector<std::string> texts;
};

/// Takes JSON apart. After a fault everything fails.
class Parser {
public:
    explicit Parser(std::string_view text) : m_text(text) {}

    bool parse(Document& document) {
        if (!element(document, 0, 0)) return false;
        skipBlanks();
        return m_at == m_text.size() || fail("the end");
    }
    std::string fault() const {
        return "The text is not JSON at byte " + std::to_string(m_at) + ": expected " + m_expected + ".";
    }

private:
    static constexpr int kDeepest = 32;

    bool fail(const char* expected) {
        m_expected = expected;
        return false;
    }
    void skipBlanks() {
        while (isAt(m_at, " \t\r\n")) ++m_at;
    }
    bool isAt(std::size_t at, std::string_view letters) const {
        return at < m_text.size() && letters.find(m_text[at]) != std::string_view::npos;
    }
    bool take(char letter) {
        skipBlanks();
        if (m_at == m_text.size() || m_text[m_at] != letter) return false;
        ++m_at;
        return true;
    }

    bool element(Document& document, std::uint32_t key, int depth) {
        if (depth > kDeepest) return fail("fewer levels");
        skipBlanks();
        const std::size_t index = document.nodes.size();
        Node node;
        node.key = key;
        document.nodes.push_back(node);
        if (!content(document, node, depth)) return false;
        node.end = static_cast<std::uint32_t>(document.nodes.size());
        document.nodes[index] = node;
        return true;
    }
    bool content(Document& document, Node& node, int depth) {
        switch (m_at < m_text.size() ? m_text[m_at] : '\0') {
            case '{': node.kind = Kind::Object; return members(document, node, depth);
            case '[': node.kind = Kind::Array; return elements(document, node, depth);
            case '"': node.kind = Kind::Text; return text(document, node.text);
            case 'n': node.kind = Kind::Null; return word("null");
            case 't': node.kind = Kind::Boolean; return word("true");
            case 'f': node.kind = Kind::Boolean; return word("false");
            default: node.kind = Kind::Number; return number(node.number);
        }
    }
    bool word(std::string_view letters) {
        if (m_text.substr(m_at, letters.size()) != letters) return fail("a value");
        m_at += letters.size();
        return true;
    }
    bool members(Document& document, Node& node, int depth) {
        ++m_at;
        if (take('}')) return true;
        do {
            std::uint32_t key = 0;
            skipBlanks();
            if (!isAt(m_at, "\"")) return fail("a key");
            if (!text(document, key)) return false;
            if (!take(':')) return fail("':'");
            if (!element(document, key, depth + 1)) return false;
            ++node.count;
        } while (take(','));
        return take('}') || fail("',' or '}'");
    }
    bool elements(Document& document, Node& node, int depth) {
        ++m_at;
        if (take(']')) return true;
        do {
            if (!element(document, 0, depth + 1)) return false;
            ++node.count;
        } while (take(','));
        return take(']') || fail("',' or ']'");
    }

    bool text(Document& document, std::uint32_t& index) {
        index = static_cast<std::uint32_t>(document.texts.size());
        return text(document.texts.emplace_back());
    }
    bool text(std::string& result) {
        for (++m_at; m_at < m_text.size(); ++m_at) {
            const char letter = m_text[m_at];
            if (letter == '"') {
                ++m_at;
                return true;
            }
            if (static_cast<unsigned char>(letter) < 0x20) break;
            if (letter != '\\') {
                result += letter;
            } else if (!escape(result)) {
                return fail("an escape");
            }
        }
        return fail("'\"'");
    }
    bool escape(std::string& result) {
        constexpr std::string_view kNames = "\"\\/bfnrt";
        constexpr std::string_view kLetters = "\"\\/\b\f\n\r\t";
        if (++m_at == m_text.size()) return false;
        const std::size_t name = kNames.find(m_text[m_at]);
        if (name != std::string_view::npos) {
            result += kLetters[name];
            return true;
        }
        std::uint32_t code = 0;
        if (m_text[m_at] != 'u' || !hex(code)) return false;
        if (code >= 0xd800 && code < 0xdc00) {
            std::uint32_t low = 0;
            if (m_text.substr(m_at + 1, 2) != "\\u") return false;
            m_at += 2;
            if (!hex(low) || low < 0xdc00 || low > 0xdfff) return false;
            code = 0x10000 + ((code - 0xd800) << 10) + (low - 0xdc00);
        } else if (code >= 0xdc00 && code <= 0xdfff) {
            return false;
        }
        appendUtf8(result, code);
        return true;
    }
    /// Four digits behind the place; leaves the place on the last.
    bool hex(std::uint32_t& code) {
        if (m_text.size() - m_at < 5) return false;
        const char* const first = m_text.data() + m_at + 1;
        const auto [end, error] = std::from_chars(first, first + 4, code, 16);
        m_at += 4;
        return error == std::errc() && end == first + 4;
    }
    static void appendUtf8(std::string& text, std::uint32_t code) {
        const auto add = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
        if (code < 0x80) return add(code);
        if (code < 0x800) {
            add(0xc0 | (code >> 6));
        } else if (code < 0x10000) {
            add(0xe0 | (code >> 12));
            add(0x80 | ((code >> 6) & 0x3f));
        } else {
            add(0xf0 | (code >> 18));
            add(0x80 | ((code >> 12) & 0x3f));
            add(0x80 | ((code >> 6) & 0x3f));
        }
        add(0x80 | (code & 0x3f));
    }

    std::size_t digitsFrom(std::size_t at) const {
        while (at < m_text.size() && m_text[at] >= '0' && m_text[at] <= '9') ++at;
        return at;
    }
    bool number(double& value) {
        const std::size_t start = m_at + (isAt(m_at, "-") ? 1 : 0);
        std::size_t end = digitsFrom(start);
        if (end == start || (m_text[start] == '0' && end > start + 1)) return fail("a value");
        if (isAt(end, ".")) {
            const std::size_t fraction = end + 1;
            end = digitsFrom(fraction);
            if (end == fraction) return fail("a number");
        }
        if (isAt(end, "eE")) {
            const std::size_t exponent = end + (isAt(end + 1, "+-") ? 2 : 1);
            end = digitsFrom(exponent);
            if (end == exponent) return fail("a number");
        }
        if (!toDouble(m_text.substr(m_at, end - m_at), value)) return fail("a number that a double can hold");
        m_at = end;
        return true;
    }
    /// The nearest double, whatever the locale; 0 for what is too small for one.
    static bool toDouble(std::string_view digits, double& value) {
#if defined(__cpp_lib_to_chars)
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error == std::errc()) return end == digits.data() + digits.size();
#else
        std::istringstream stream{std::string(digits)};
        stream.imbue(std::locale::classic());
        if (stream >> value) return std::isfinite(value);
#endif
        value = 0.0;
        return isBelowOne(digits);
    }

    /// Whether the magnitude of a number is below 1.
    static bool isBelowOne(std::string_view digits) {
        const std::size_t e = std::min(digits.find_first_of("eE"), digits.size());
        const std::size_t point = std::min(digits.find('.'), e);
        const std::size_t first = digits.find_first_of("123456789");
        if (first >= e) return true;
        long exponent = 0;
        for (const char digit : digits.substr(e)) {
            if (digit >= '0' && digit <= '9') exponent = std::min(10 * exponent + (digit - '0'), 1000000000L);
        }
        if (digits.find('-', e) != digits.npos) exponent = -exponent;
        return exponent + static_cast<long>(point) - static_cast<long>(first) <= 0;
    }

    std::string_view m_text;
    std::size_t m_at = 0;
    const char* m_expected = "";
};

/// A value in a document, with the place where it stands.
struct Value {
    const Document* document = nullptr;
    std::uint32_t node = 0;
    const Value* parent = nullptr;  // null at the root
    const char* key = nullptr;      // in an object
    std::size_t number = 0;         // in an array

    const Node& operator*() const { return document->nodes[node]; }
    const Node* operator->() const { return &document->nodes[node]; }
    std::string place() const {
        if (!parent) return "";
        const std::string before = parent->place();
        if (!key) return before + "[" + std::to_string(number) + "]";
        return before.empty() ? key : before + "." + key;
    }
};

/// Reads values, and keeps the first fault with its place. After it everything reads as nothing.
class Reader {
public:
    std::string fault;

    void refuse(const Value& value, const std::string& reason) {
        const std::string place = value.place();
        if (fault.empty()) fault = (place.empty() ? "The document" : place) + ": " + reason + ".";
    }
    bool is(const Value& value, Kind kind, const char* expected) {
        if (fault.empty() && value->kind != kind) refuse(value, std::string("expected ") + expected);
        return fault.empty();
    }
    /// A member of an object; none if it is missing.
    static std::optional<Value> find(const Value& object, const char* key) {
        const std::vector<Node>& nodes = object.document->nodes;
        for (std::uint32_t child = object.node + 1; child < object->end; child = nodes[child].end) {
            if (object.document->texts[nodes[child].key] == key) return Value{object.document, child, &object, key, 0};
        }
        return std::nullopt;
    }
    /// What `read` makes of a member of an object.
    template <class Read>
    auto at(const Value& object, const char* key, Read read) {
        if (is(object, Kind::Object, "an object")) {
            if (const std::optional<Value> value = find(object, key)) return read(*value);
            refuse(object, std::string("the key \"") + key + "\" is missing");
        }
        return decltype(read(object)){};
    }
    /// The same; of a missing one `absent`.
    template <class Read>
    auto at(const Value& object, const char* key, Read read, decltype(read(object)) absent) {
        const std::optional<Value> value = is(object, Kind::Object, "an object") ? find(object, key) : std::nullopt;
        return value ? read(*value) : absent;
    }
    double number(const Value& value) { return is(value, Kind::Number, "a number") ? value->number : 0.0; }
    double positive(const Value& value) {
        const double read = number(value);
        if (fault.empty() && !(read > 0.0)) refuse(value, "expected a number above 0");
        return read;
    }
    /// A whole number below `end`.
    std::uint32_t index(const Value& value, std::size_t end) {
        const double read = number(value);
        if (fault.empty() && read >= 0.0 && read < static_cast<double>(end) && read == std::floor(read))
            return static_cast<std::uint32_t>(read);
        refuse(value, "expected a whole number below " + std::to_string(end));
        return 0;
    }
    /// The same, or null.
    std::uint32_t link(const Value& value, std::size_t end) {
        return value->kind == Kind::Null ? kNone : index(value, end);
    }
    std::string text(const Value& value) {
        return is(value, Kind::Text, "a text") ? value.document->texts[value->text] : std::string();
    }
    /// Which of the words it is.
    template <class Words>
    std::size_t oneOf(const Value& value, const Words& words) {
        const std::string read = text(value);
        const auto found = std::find(std::begin(words), std::end(words), read);
        if (found == std::end(words)) refuse(value, "\"" + read + "\" is not known to this reader");
        return found == std::end(words) ? 0 : static_cast<std::size_t>(found - std::begin(words));
    }
    std::size_t oneOf(const Value& value, std::initializer_list<std::string_view> words) {
        return oneOf<std::initializer_list<std::string_view>>(value, words);
    }
    /// Calls `visit` with every element of an array.
    template <class Visit>
    void forEach(const Value& value, Visit visit) {
        if (!is(value, Kind::Array, "an array")) return;
        std::size_t number = 0;
        for (std::uint32_t child = value.node + 1; child < value->end && fault.empty();) {
            visit(Value{value.document, child, &value, nullptr, number++});
            child = value.document->nodes[child].end;
        }
    }
    /// An array, each element by `read`.
    template <class Read>
    auto list(const Value& value, Read read) {
        std::vector<decltype(read(value))> elements;
        elements.reserve(value->count);
        forEach(value, [&](const Value& element) { elements.push_back(read(element)); });
        return elements;
    }
    template <std::size_t Count>
    std::array<double, Count> numbers(const Value& value) {
        std::array<double, Count> read{};
        if (is(value, Kind::Array, "an array") && value->count != Count)
            refuse(value, "expected " + std::to_string(Count) + " numbers");
        forEach(value, [&](const Value& element) { read[element.number] = number(element); });
        return read;
    }
    Vec3 vector(const Value& value) {
        const std::array<double, 3> read = numbers<3>(value);
        return {read[0], read[1], read[2]};
    }
    std::string textAt(const Value& object, const char* key) {
        return at(object, key, [&](const Value& value) { return text(value); });
    }
    /// A number that may be missing, at least 0.
    double optionalAt(const Value& object, const char* key) {
        const double read = at(
            object, key, [&](const Value& value) { return number(value); }, 0.0);
        if (!(read >= 0.0)) refuse(object, std::string("the key \"") + key + "\" is below 0");
        return read;
    }
    double numberAt(const Value& object, const char* key) {
        return at(object, key, [&](const Value& value) { return number(value); });
    }
    double positiveAt(const Value& object, const char* key) {
        return at(object, key, [&](const Value& value) { return positive(value); });
    }
    Vec3 vectorAt(const Value& object, const char* key) {
        return at(object, key, [&](const Value& value) { return vector(value); });
    }
    std::size_t oneOfAt(const Value& object, const char* key, std::initializer_list<std::string_view> words) {
        return at(object, key, [&](const Value& value) { return oneOf(value, words); });
    }
    std::uint32_t linkAt(const Value& object, const char* key, std::size_t end) {
        return at(object, key, [&](const Value& value) { return link(value, end); });
    }
    template <class Read>
    auto listAt(const Value& object, const char* key, Read read) {
        return at(object, key, [&](const Value& value) { return list(value, read); });
    }

    Hull hull(const Value& value) {
        Hull read;
        read.vertices = listAt(value, "vertices", [&](const Value& v) { return vector(v); });
        const auto vertex = [&](const Value& v) { return index(v, read.vertices.size()); };
        read.edges = listAt(value, "edges", [&](const Value& v) {
            std::array<std::uint32_t, 2> ends{};
            if (is(v, Kind::Array, "an array") && v->count != 2) refuse(v, "expected 2 vertices");
            forEach(v, [&](const Value& end) { ends[end.number] = vertex(end); });
            return ends;
        });
        read.faces = listAt(value, "faces", [&](const Value& v) { return list(v, vertex); });
        const auto signedEdge = [&](const Value& v) {
            const std::array<double, 2> pair = numbers<2>(v);
            if (!(pair[0] >= 0.0 && pair[0] < static_cast<double>(read.edges.size()) && pair[0] == std::floor(pair[0])))
                refuse(v, "expected an edge that is there");
            if (pair[1] != 1.0 && pair[1] != -1.0) refuse(v, "expected an edge, then 1 or -1");
            return fault.empty() ? SignedEdge{static_cast<std::uint32_t>(pair[0]), pair[1] > 0.0 ? 1 : -1}
                                 : SignedEdge{};
        };
        read.signedEdges = listAt(value, "signedEdges", [&](const Value& v) { return list(v, signedEdge); });
        read.planes = listAt(value, "planes", [&](const Value& v) {
            const std::array<double, 4> plane = numbers<4>(v);
            return Plane{{plane[0], plane[1], plane[2]}, plane[3]};
        });
        bool agree = read.faces.size() == read.planes.size() && read.faces.size() == read.signedEdges.size();
        for (std::size_t f = 0; agree && f < read.faces.size(); ++f) {
            agree = read.faces[f].size() >= 3 && read.faces[f].size() == read.signedEdges[f].size();
        }
        if (!agree) refuse(value, "faces, signed edges and planes do not agree");
        return read;
    }
    Neighbour neighbour(const Value& value, std::size_t count) {
        const auto fragment = at(value, "fragment", [&](const Value& v) { return index(v, count); });
        return {fragment, positiveAt(value, "area")};
    }
    /// A body that is a piece of one of the `before` first fragments, of `count`.
    Body body(const Value& value, std::size_t before, std::size_t count) {
        Body read;
        read.id = textAt(value, "id");
        read.name = textAt(value, "name");
        read.parent = linkAt(value, "parent", before);
        read.offset = vectorAt(value, "offset");
        read.volume = positiveAt(value, "volume");
        read.mass = positiveAt(value, "mass");
        read.centreOfMass = vectorAt(value, "centreOfMass");
        at(value, "inertia", [&](const Value& v) {
            if (is(v, Kind::Array, "an array") && v->count != 3) refuse(v, "expected 3 rows");
            forEach(v, [&](const Value& row) { read.inertia[row.number] = numbers<3>(row); });
            return 0;
        });
        read.threshold = optionalAt(value, "threshold");
        read.gap = optionalAt(value, "gap");
        read.lostMass = optionalAt(value, "lostMass");
        read.neighbours = listAt(value, "neighbours", [&](const Value& v) { return neighbour(v, count); });
        read.hulls = listAt(value, "hulls", [&](const Value& v) { return hull(v); });
        if (read.hulls.empty()) refuse(value, "expected at least one hull");
        return read;
    }
    Material material(const Value& value) {
        Material read;
        read.name = textAt(value, "name");
        read.density = positiveAt(value, "density");
        read.friction = numberAt(value, "friction");
        read.restitution = numberAt(value, "restitution");
        read.outside = at(value, "outside", [&](const Value& v) { return numbers<3>(v); });
        read.inside = at(value, "inside", [&](const Value& v) { return numbers<3>(v); });
        return read;
    }
    Mesh mesh(const Value& value, std::size_t count) {
        Mesh read;
        read.file = textAt(value, "file");
        read.bodies = static_cast<MeshBodies>(oneOfAt(value, "bodies", {"whole", "fragments", "fragment"}));
        read.fragment = linkAt(value, "fragment", count);
        read.place = static_cast<MeshPlace>(oneOfAt(value, "place", {"assembled", "centred"}));
        return read;
    }
    /// Refuses what is no pack, or none that this header can read.
    void checkFormat(const Value& root) {
        oneOfAt(root, "format", {"rubble-pack"});
        at(root, "version", [&](const Value& version) {
            if (number(version) != kVersion) refuse(version, "this header reads version " + std::to_string(kVersion));
            return 0;
        });
        at(root, "units", [&](const Value& units) {
            oneOfAt(units, "length", {"m"});
            oneOfAt(units, "mass", {"kg"});
            return oneOfAt(units, "time", {"s"});
        });
        at(root, "axes", [&](const Value& axes) {
            oneOfAt(axes, "handedness", {"right"});
            oneOfAt(axes, "up", {"y"});
            return oneOfAt(axes, "front", {"counter-clockwise"});
        });
    }
    Pack pack(const Value& root) {
        Pack read;
        checkFormat(root);
        at(root, "asset", [&](const Value& asset) {
            read.name = textAt(asset, "name");
            return read.asset = at(asset, "id", [&](const Value& id) { return index(id, std::size_t{kNone}); });
        });
        read.hash = textAt(root, "hash");
        read.threshold = positiveAt(root, "threshold");
        read.material = at(root, "material", [&](const Value& value) { return material(value); });
        read.whole = at(root, "whole", [&](const Value& value) { return body(value, 0, 0); });
        read.fragments = at(root, "fragments", [&](const Value& value) {
            const std::size_t count = value->count;
            return list(value, [&](const Value& element) { return body(element, element.number, count); });
        });
        const std::size_t count = read.fragments.size();
        read.meshes = listAt(root, "meshes", [&](const Value& value) { return mesh(value, count); });
        return read;
    }

    static constexpr std::array<std::string_view, kEventKinds> kKinds{"impact", "bonds",   "detached",
                                                                      "broken", "settled", "removed"};
    static constexpr double kMaxCount = 9007199254740992.0;  // the whole numbers below are doubles

    std::uint64_t step(const Value& value) {
        return at(value, "step", [&](const Value& v) {
            const double read = number(v);
            if (fault.empty() && !(read >= 0.0 && read < kMaxCount && read == std::floor(read)))
                refuse(v, "expected a step");
            return fault.empty() ? static_cast<std::uint64_t>(read) : 0;
        });
    }
    std::uint32_t countAt(const Value& value, const char* key) {
        return at(value, key, [&](const Value& v) { return index(v, std::size_t{kNone}); });
    }
    Box box(const Value& value) {
        const std::vector<Vec3> corners = list(value, [&](const Value& v) { return vector(v); });
        if (fault.empty() && corners.size() != 2) refuse(value, "expected 2 corners");
        return fault.empty() ? Box{corners[0], corners[1]} : Box{};
    }
    Event event(const Value& value) {
        const auto optionalNumber = [&](const char* key) {
            return at(
                value, key, [&](const Value& v) { return number(v); }, 0.0);
        };
        const auto whole = [&](const Value& v) { return index(v, std::size_t{kNone}); };
        Event read;
        read.step = step(value);
        read.kind = at(value, "kind", [&](const Value& v) { return static_cast<EventKind>(oneOf(v, kKinds)); });
        read.body = countAt(value, "body");
        read.other = at(value, "other", whole, kNone);
        read.instance = countAt(value, "instance");
        read.fragment = textAt(value, "fragment");
        read.point = vectorAt(value, "point");
        read.normal = at(
            value, "normal", [&](const Value& v) { return vector(v); }, Vec3{});
        read.impulse = optionalNumber("impulse");
        read.speed = optionalNumber("speed");
        read.energy = optionalNumber("energy");
        read.area = optionalNumber("area");
        read.mass = optionalNumber("mass");
        read.count = at(value, "count", whole, 0u);
        read.materials = at(value, "materials", [&](const Value& v) {
            const std::vector<std::uint32_t> pair = list(v, whole);
            if (fault.empty() && pair.size() != 2) refuse(v, "expected 2 materials");
            return fault.empty() ? std::array<std::uint32_t, 2>{pair[0], pair[1]} : std::array<std::uint32_t, 2>{};
        });
        read.box = at(value, "box", [&](const Value& v) { return box(v); });
        read.reason = at(
            value, "reason",
            [&](const Value& v) {
                return static_cast<RemovalReason>(1 + oneOf(v, {"lifetime", "budget", "leftWorld"}));
            },
            RemovalReason::None);
        return read;
    }
    EventSums sums(const Value& value) {
        EventSums read;
        read.step = step(value);
        read.restEnergy = numberAt(value, "restEnergy");
        at(value, "omitted", [&](const Value& omitted) {
            std::size_t kind = 0;
            for (const std::string_view name : kKinds) {
                read.omitted[kind++] = at(
                    omitted, name.data(),
                    [&](const Value& v) {
                        return OmittedEvents{countAt(v, "count"), numberAt(v, "energy")};
                    },
                    OmittedEvents{});
            }
            return 0;
        });
        return read;
    }
    /// Adds a line of events to a log.
    void addLine(const Value& value, EventLog& log) {
        if (textAt(value, "kind") == "sums") {
            log.sums.push_back(sums(value));
        } else {
            log.events.push_back(event(value));
        }
    }
};

/// The bytes of a file; none if it cannot be read.
inline std::optional<std::string> bytesOf(const std::string& path, std::string& fault) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream bytes;
    if (file && (file.peek() == std::ifstream::traits_type::eof() || bytes << file.rdbuf())) return bytes.str();
    fault = "Cannot read \"" + path + "\".";
    return std::nullopt;
}

}  // namespace detail

inline bool parse(std::string_view json, Pack& pack, std::string& fault) {
    detail::Parser parser(json);
    detail::Document document;
    if (!parser.parse(document)) {
        fault = parser.fault();
        return false;
    }
    detail::Reader reader;
    Pack read = reader.pack(detail::Value{&document, 0, nullptr, nullptr, 0});
    if (!reader.fault.empty()) {
        fault = reader.fault;
        return false;
    }
    pack = std::move(read);
    return true;
}

inline bool load(const std::string& path, Pack& pack, std::string& fault) {
    const std::optional<std::string> json = detail::bytesOf(path, fault);
    if (!json) return false;
    if (parse(*json, pack, fault)) return true;
    fault = "\"" + path + "\": " + fault;
    return false;
}

inline bool parseEvents(std::string_view lines, EventLog& log, std::string& fault) {
    EventLog read;
    for (std::size_t start = 0, number = 1; start < lines.size(); ++number) {
        const std::size_t end = std::min(lines.find('\n', start), lines.size());
        detail::Parser parser(lines.substr(start, end - start));
        detail::Document document;
        detail::Reader reader;
        if (parser.parse(document)) {
            reader.addLine(detail::Value{&document, 0, nullptr, nullptr, 0}, read);
        } else {
            reader.fault = parser.fault();
        }
        if (!reader.fault.empty()) {
            fault = "Line " + std::to_string(number) + ": " + reader.fault;
            return false;
        }
        start = end + 1;
    }
    log = std::move(read);
    return true;
}

inline bool loadEvents(const std::string& path, EventLog& log, std::string& fault) {
    const std::optional<std::string> lines = detail::bytesOf(path, fault);
    if (!lines) return false;
    if (parseEvents(*lines, log, fault)) return true;
    fault = "\"" + path + "\": " + fault;
    return false;
}

}  // namespace rubble_pack
