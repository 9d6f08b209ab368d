#include "core/base/Hash.h"
#include "core/geometry/hull/PolytopeTopology.h"
#include "core/io/pack/PackBinary.h"
#include "core/io/pack/PackBinaryFormat.h"
#include "core/io/pack/PackFormat.h"
#include "core/io/pack/PackHeaderJson.h"

#include <cmath>
#include <cstring>
#include <map>

namespace rubble {
namespace {

Error malformedBinary(const std::string& what) {
    return {ErrorCode::BadInput, "pack.bin cannot be read: " + what + "; export it again."};
}

Vec3 toVector(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }

/// The sections of a file whose sizes have been checked.
class BinarySections {
public:
    /// Errors: as readPackBinary().
    static Result<BinarySections> of(std::string_view bytes) {
        BinarySections sections;
        sections.m_bytes = bytes;
        if (bytes.size() < sizeof(BinaryHead) + kBinaryChecksum)
            return malformedBinary("it has " + std::to_string(bytes.size()) + " bytes only");
        BinaryHead head;
        std::memcpy(&head, bytes.data(), sizeof(head));
        if (std::string_view(head.magic.data(), head.magic.size()) != kBinaryMagic)
            return malformedBinary("it does not start with " + std::string(kBinaryMagic));
        if (head.version > kBinaryVersion) {
            return Error{ErrorCode::Unsupported, "pack.bin has version " + std::to_string(head.version) +
                                                     ", but this program reads versions up to " +
                                                     std::to_string(kBinaryVersion) + "; open it with a newer one."};
        }
        if (head.version != kBinaryVersion) return malformedBinary("it has version 0");
        if (head.fileSize != bytes.size())
            return malformedBinary("it has " + std::to_string(bytes.size()) + " bytes instead of " +
                                   std::to_string(head.fileSize));
        const std::string_view content = bytes.substr(0, bytes.size() - kBinaryChecksum);
        std::uint64_t checksum = 0;
        std::memcpy(&checksum, bytes.data() + content.size(), sizeof(checksum));
        if (contentHash(content).low != checksum) return malformedBinary("its checksum does not fit");
        const std::size_t table = sizeof(head) + std::size_t{head.sectionCount} * sizeof(BinarySectionEntry);
        if (table > content.size()) return malformedBinary("its table of sections does not fit");
        sections.m_entries.resize(head.sectionCount);
        std::memcpy(sections.m_entries.data(), bytes.data() + sizeof(head), table - sizeof(head));
        for (const BinarySectionEntry& entry : sections.m_entries) {
            const bool fits = entry.offset <= content.size() && entry.elementSize > 0 &&
                              entry.count <= (content.size() - entry.offset) / entry.elementSize;
            if (!fits) return malformedBinary("section " + std::to_string(entry.kind) + " does not fit");
        }
        return sections;
    }

    /// The elements of a section; their type may have grown. Nothing if it is missing or its elements are too small.
    template <class T>
    std::optional<std::vector<T>> list(BinarySection kind) const {
        for (const BinarySectionEntry& entry : m_entries) {
            if (entry.kind != static_cast<std::uint32_t>(kind)) continue;
            if (entry.elementSize < sizeof(T)) return std::nullopt;
            std::vector<T> elements(entry.count);
            for (std::size_t k = 0; k < elements.size(); ++k)
                std::memcpy(&elements[k], m_bytes.data() + entry.offset + k * entry.elementSize, sizeof(T));
            return elements;
        }
        return std::nullopt;
    }

private:
    std::string_view m_bytes;
    std::vector<BinarySectionEntry> m_entries;
};

/// Makes bodies of the arrays of a file, and keeps the first fault.
class BinaryBodies {
public:
    explicit BinaryBodies(const BinarySections& sections) {
        const auto take = [&](auto& list, BinarySection kind, const char* name) {
            using T = typename std::remove_reference_t<decltype(list)>::value_type;
            auto found = sections.list<T>(kind);
            if (found) list = std::move(*found);
            if (!found) fail(std::string("its ") + name + " are missing");
        };
        take(m_bodies, BinarySection::Bodies, "bodies");
        take(m_hulls, BinarySection::Hulls, "hulls");
        take(m_vertices, BinarySection::Vertices, "vertices");
        take(m_loops, BinarySection::Loops, "loops");
        take(m_contacts, BinarySection::Contacts, "contacts");
        take(m_texts, BinarySection::Texts, "texts");
        if (m_bodies.empty()) fail("it has no bodies");
        if (m_texts.empty() || m_texts.back() != '\0') fail("its texts do not end");
    }

    const std::optional<std::string>& fault() const { return m_fault; }
    std::size_t fragmentCount() const { return m_bodies.size() - 1; }

    /// A fragment; kNone: the whole.
    PackBody body(std::uint32_t fragment) {
        const BinaryBody& record = m_bodies[fragment == kNone ? 0 : fragment + 1];
        PackBody body;
        body.id = text(record.id);
        body.name = text(record.name);
        body.parent = record.parent;
        body.level = record.level;
        body.firstChild = record.firstChild;
        body.childCount = record.childCount;
        if (record.parent != kNone && (fragment == kNone || record.parent >= fragment))
            fail("the parent of a body does not precede it");
        if (std::size_t{record.firstChild} + record.childCount > fragmentCount())
            fail("the children of a body do not exist");
        body.offset = {record.offset[0], record.offset[1], record.offset[2]};
        body.volume = record.volume;
        body.mass = record.mass;
        const auto& q = record.rotation;
        body.principal = PrincipalInertia{toVector(record.moments), Quat(q[3], q[0], q[1], q[2])};
        body.inertia = tensorOf(*body.principal);
        body.bounds = PackBounds{toVector(record.min), toVector(record.max), record.radius, record.thinnest};
        if (record.threshold > 0.0) body.threshold = record.threshold;
        body.gap = record.gap;
        body.lostMass = record.lostMass;
        if (std::size_t{record.firstHull} + record.hullCount > m_hulls.size()) fail("the hulls of a body do not exist");
        for (std::size_t k = 0; !m_fault && k < record.hullCount; ++k)
            body.hulls.push_back(hull(m_hulls[record.firstHull + k]));
        return body;
    }

    /// Adds the contacts to the fragments of both, and to the bonds, which need the rule.
    void addContacts(Pack& pack) {
        for (const BinaryContact& contact : m_contacts) {
            if (contact.first >= contact.second || contact.second >= pack.fragments.size())
                return fail("a contact is not between two fragments in ascending order");
            const Vec3 centroid = toVector(contact.centroid), normal = toVector(contact.normal);
            pack.fragments[contact.first].neighbours.push_back({contact.second, contact.area, centroid, normal});
            pack.fragments[contact.second].neighbours.push_back({contact.first, contact.area, {}, {}});
        }
        for (PackBody& body : pack.fragments) std::ranges::sort(body.neighbours, {}, &PackNeighbour::fragment);
        if (pack.bonding) addBonds(pack);
    }

private:
    void fail(const std::string& what) {
        if (!m_fault) m_fault = what;
    }
    std::string text(std::uint32_t start) {
        if (start < m_texts.size()) return m_texts.data() + start;
        fail("a text does not exist");
        return {};
    }
    PackHull hull(const BinaryHull& record) {
        PackHull hull{.inset = record.inset};
        if (std::size_t{record.firstVertex} + record.vertexCount > m_vertices.size()) {
            fail("the vertices of a hull do not exist");
            return hull;
        }
        std::vector<Vec3> vertices;
        for (std::size_t k = 0; k < record.vertexCount; ++k)
            vertices.push_back(toVector(m_vertices[record.firstVertex + k]));
        std::vector<std::vector<std::uint32_t>> faces;
        std::size_t at = record.firstLoop;
        for (std::size_t k = 0; k < record.faceCount; ++k) {
            const std::size_t count = at < m_loops.size() ? m_loops[at] : 0;
            if (count < 3 || at + count >= m_loops.size()) {
                fail("the faces of a hull do not exist");
                return hull;
            }
            const auto first = m_loops.begin() + static_cast<std::ptrdiff_t>(at) + 1;
            faces.emplace_back(first, first + static_cast<std::ptrdiff_t>(count));
            at += count + 1;
        }
        std::optional<Polytope> polytope = polytopeOf(std::move(vertices), std::move(faces));
        if (!polytope) fail("a face of a hull has no area or a vertex that does not exist");
        if (polytope) hull.polytope = std::move(*polytope);
        return hull;
    }
    void addBonds(Pack& pack) {
        std::vector<PackFracture>& fractures = pack.bonding->fractures;
        std::map<std::uint32_t, std::size_t> fractureOf;  // by body
        const auto addFracture = [&](std::uint32_t fragment, const PackBody& body) {
            if (body.childCount < 2) return;
            fractureOf[fragment] = fractures.size();
            fractures.push_back({.fragment = fragment});
        };
        addFracture(kNone, pack.whole);
        for (std::uint32_t k = 0; k < pack.fragments.size(); ++k) addFracture(k, pack.fragments[k]);
        for (const BinaryContact& contact : m_contacts) {
            const auto fracture = fractureOf.find(pack.fragments[contact.first].parent);
            if (fracture == fractureOf.end()) return fail("a contact is between fragments of a body that has one only");
            PackBond& bond = fractures[fracture->second].bonds.emplace_back();
            bond.fragments = {contact.first, contact.second};
            bond.area = contact.area;
            bond.centroid = toVector(contact.centroid);
            bond.normal = toVector(contact.normal);
            if (std::isfinite(contact.capacity)) bond.capacity = contact.capacity;
            bond.clusterLevel = contact.clusterLevel;
        }
    }

    std::vector<BinaryBody> m_bodies;
    std::vector<BinaryHull> m_hulls;
    std::vector<BinaryVertex> m_vertices;
    std::vector<std::uint16_t> m_loops;
    std::vector<BinaryContact> m_contacts;
    std::vector<char> m_texts;
    std::optional<std::string> m_fault;
};

}  // namespace

Result<Pack> readPackBinary(std::string_view bytes) {
    const Result<BinarySections> sections = BinarySections::of(bytes);
    if (!sections) return sections.error();
    const auto header = sections->list<char>(BinarySection::Header);
    if (!header) return malformedBinary("its header is missing");
    Result<JsonDocument> document = JsonDocument::parse(std::string_view(header->data(), header->size()));
    if (!document) return document.error();
    const Result<std::uint32_t> version = versionOf(*document, kPackFormat);
    if (!version) return version.error();
    Pack pack = readPackHeader(document->root(), *version);
    if (document->firstError()) return *document->firstError();
    pack.checksum.clear();
    BinaryBodies bodies(*sections);
    if (bodies.fault()) return malformedBinary(*bodies.fault());
    pack.whole = bodies.body(kNone);
    for (std::uint32_t k = 0; k < bodies.fragmentCount(); ++k) pack.fragments.push_back(bodies.body(k));
    if (!bodies.fault()) bodies.addContacts(pack);
    if (bodies.fault()) return malformedBinary(*bodies.fault());
    return pack;
}

}  // namespace rubble
