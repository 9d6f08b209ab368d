#include "core/io/pack/PackBinary.h"

#include "core/base/Hash.h"
#include "core/base/Parallel.h"
#include "core/io/pack/PackBinaryFormat.h"
#include "core/io/pack/PackHeaderJson.h"

#include <functional>
#include <limits>
#include <vector>

namespace rubble {
namespace {

constexpr std::size_t kBinaryChunk = 256;  // bodies of a task

/// The arrays of a file, or of some of its bodies.
struct BinaryArrays {
    std::vector<BinaryBody> bodies;
    std::vector<BinaryHull> hulls;
    std::vector<BinaryVertex> vertices;
    std::vector<std::uint16_t> loops;  // of each face: the number of its vertices, then these, within the hull
    std::vector<BinaryContact> contacts;
    std::string texts;          // each ends with a zero
    bool hasLargeHull = false;  // one has too many vertices for its loops
};

/// Adding zero turns -0 into 0, as pack.json does.
float toFloat(double value) { return static_cast<float>(value) + 0.0f; }
std::array<float, 3> toFloats(Vec3 v) { return {toFloat(v.x), toFloat(v.y), toFloat(v.z)}; }

std::uint32_t sizeNow(std::size_t size) { return static_cast<std::uint32_t>(size); }

std::uint32_t addBinaryText(BinaryArrays& arrays, const std::string& text) {
    const std::uint32_t start = sizeNow(arrays.texts.size());
    arrays.texts += text;
    arrays.texts += '\0';
    return start;
}

void addBinaryHull(BinaryArrays& arrays, const PackHull& hull) {
    const Polytope& polytope = hull.polytope;
    BinaryHull& record = arrays.hulls.emplace_back();
    record.firstVertex = sizeNow(arrays.vertices.size());
    record.vertexCount = sizeNow(polytope.vertices.size());
    record.firstLoop = sizeNow(arrays.loops.size());
    record.faceCount = sizeNow(polytope.faces.size());
    record.inset = toFloat(hull.inset);
    for (const Vec3& vertex : polytope.vertices) arrays.vertices.push_back(toFloats(vertex));
    arrays.hasLargeHull |= polytope.vertices.size() > std::numeric_limits<std::uint16_t>::max();
    for (const std::vector<SignedEdge>& loop : signedEdgeLoops(polytope)) {
        arrays.loops.push_back(static_cast<std::uint16_t>(loop.size()));
        for (const SignedEdge step : loop)
            arrays.loops.push_back(static_cast<std::uint16_t>(polytope.edges[step.edge][step.sign > 0 ? 0 : 1]));
    }
}

void addBinaryContacts(BinaryArrays& arrays, std::uint32_t own, const PackBody& body) {
    for (const PackNeighbour& neighbour : body.neighbours) {
        if (!neighbour.centroid || !neighbour.normal) continue;
        BinaryContact& contact = arrays.contacts.emplace_back();
        contact.first = own;
        contact.second = neighbour.fragment;
        contact.area = toFloat(neighbour.area);
        contact.centroid = toFloats(*neighbour.centroid);
        contact.normal = toFloats(*neighbour.normal);
    }
}

/// Adds a body, `own` being its index among the fragments.
void addBinaryBody(BinaryArrays& arrays, std::uint32_t own, const PackBody& body) {
    BinaryBody record;
    record.offset = {body.offset.x + 0.0, body.offset.y + 0.0, body.offset.z + 0.0};
    record.mass = body.mass;
    record.volume = body.volume;
    record.threshold = body.threshold.value_or(0.0);
    record.gap = body.gap;
    record.lostMass = body.lostMass;
    const PrincipalInertia principal = body.principal.value_or(principalInertia(body.inertia));
    record.moments = toFloats(principal.moments);
    const Quat& q = principal.rotation;
    record.rotation = {toFloat(q.x), toFloat(q.y), toFloat(q.z), toFloat(q.w)};
    const PackBounds bounds = body.bounds.value_or(PackBounds{});
    record.min = toFloats(bounds.min);
    record.max = toFloats(bounds.max);
    record.radius = toFloat(bounds.radius);
    record.thinnest = toFloat(bounds.thinnest);
    record.parent = body.parent;
    record.level = body.level;
    record.firstChild = body.firstChild;
    record.childCount = body.childCount;
    record.firstHull = sizeNow(arrays.hulls.size());
    record.hullCount = sizeNow(body.hulls.size());
    record.id = addBinaryText(arrays, body.id);
    record.name = addBinaryText(arrays, body.name);
    arrays.bodies.push_back(record);
    for (const PackHull& hull : body.hulls) addBinaryHull(arrays, hull);
    addBinaryContacts(arrays, own, body);
}

template <class T>
void appendAll(std::vector<T>& all, const std::vector<T>& more) {
    all.insert(all.end(), more.begin(), more.end());
}

/// Appends the arrays of further bodies.
void appendBodies(BinaryArrays& all, BinaryArrays more) {
    for (BinaryBody& body : more.bodies) {
        body.firstHull += sizeNow(all.hulls.size());
        body.id += sizeNow(all.texts.size());
        body.name += sizeNow(all.texts.size());
    }
    for (BinaryHull& hull : more.hulls) {
        hull.firstVertex += sizeNow(all.vertices.size());
        hull.firstLoop += sizeNow(all.loops.size());
    }
    appendAll(all.bodies, more.bodies);
    appendAll(all.hulls, more.hulls);
    appendAll(all.vertices, more.vertices);
    appendAll(all.loops, more.loops);
    appendAll(all.contacts, more.contacts);
    all.texts += more.texts;
    all.hasLargeHull |= more.hasLargeHull;
}

/// Sets what holds the contacts of a bonded asset: its bonds are the contacts, in their order.
void addBonds(BinaryArrays& arrays, const PackBonding& bonding) {
    std::size_t next = 0;
    for (const PackFracture& fracture : bonding.fractures) {
        for (const PackBond& bond : fracture.bonds) {
            BinaryContact& contact = arrays.contacts[next++];
            RUBBLE_ASSERT(contact.first == bond.fragments[0] && contact.second == bond.fragments[1]);
            contact.capacity = bond.capacity ? toFloat(*bond.capacity) : std::numeric_limits<float>::infinity();
            contact.clusterLevel = bond.clusterLevel;
        }
    }
}

/// Appends the arrays of a file.
class SectionWriter {
public:
    explicit SectionWriter(std::string& bytes) : m_bytes(bytes) {
        m_bytes.assign(sizeof(BinaryHead) + kBinarySections * sizeof(BinarySectionEntry), '\0');
    }
    template <class T>
    void add(BinarySection kind, std::span<const T> elements) {
        m_bytes.resize((m_bytes.size() + kSectionAlignment - 1) / kSectionAlignment * kSectionAlignment, '\0');
        m_entries.push_back(
            {static_cast<std::uint32_t>(kind), std::uint32_t{sizeof(T)}, m_bytes.size(), elements.size()});
        m_bytes.append(reinterpret_cast<const char*>(elements.data()), elements.size_bytes());
    }
    /// Fills in the head and the table, and appends the checksum.
    void finish() {
        RUBBLE_ASSERT(m_entries.size() == kBinarySections);
        BinaryHead head{.version = kBinaryVersion, .sectionCount = kBinarySections};
        kBinaryMagic.copy(head.magic.data(), head.magic.size());
        head.fileSize = m_bytes.size() + kBinaryChecksum;
        std::memcpy(m_bytes.data(), &head, sizeof(head));
        std::memcpy(m_bytes.data() + sizeof(head), m_entries.data(), m_entries.size() * sizeof(m_entries[0]));
        const std::uint64_t checksum = contentHash(m_bytes).low;
        m_bytes.append(reinterpret_cast<const char*>(&checksum), sizeof(checksum));
    }

private:
    std::string& m_bytes;
    std::vector<BinarySectionEntry> m_entries;
};

bool isTooLarge(const BinaryArrays& arrays) {
    constexpr std::size_t kMost = std::numeric_limits<std::uint32_t>::max();
    return arrays.vertices.size() > kMost || arrays.loops.size() > kMost || arrays.texts.size() > kMost;
}

Result<std::string> encoded(const BinaryArrays& arrays, const Pack& header) {
    if (arrays.hasLargeHull)
        return Error{ErrorCode::Limit,
                     "A hull has more than 65,535 vertices, the maximum of pack.bin; export without it."};
    if (isTooLarge(arrays))
        return Error{ErrorCode::Limit, "The hulls exceed the size of pack.bin, 4 billion vertices; export without it."};
    const std::string json = packHeaderJson(header);
    std::string bytes;
    SectionWriter sections(bytes);
    sections.add(BinarySection::Header, std::span(json.data(), json.size()));
    sections.add(BinarySection::Bodies, std::span(arrays.bodies));
    sections.add(BinarySection::Hulls, std::span(arrays.hulls));
    sections.add(BinarySection::Vertices, std::span(arrays.vertices));
    sections.add(BinarySection::Loops, std::span(arrays.loops));
    sections.add(BinarySection::Contacts, std::span(arrays.contacts));
    sections.add(BinarySection::Texts, std::span(arrays.texts.data(), arrays.texts.size()));
    sections.finish();
    return bytes;
}

/// Encodes a whole and `count` fragments, each given by its index.
Result<std::string> encoded(const Pack& header, const PackBody& whole, std::size_t count, int threads,
                            const std::function<void(BinaryArrays&, std::uint32_t)>& addFragment) {
    std::vector<BinaryArrays> chunks((count + kBinaryChunk - 1) / kBinaryChunk);
    forEachIndex(chunks.size(), threads, [&](std::size_t chunk) {
        const std::size_t end = std::min(count, kBinaryChunk * (chunk + 1));
        for (std::size_t k = kBinaryChunk * chunk; k < end; ++k) addFragment(chunks[chunk], sizeNow(k));
    });
    BinaryArrays arrays;
    addBinaryBody(arrays, kNone, whole);
    for (BinaryArrays& chunk : chunks) appendBodies(arrays, std::move(chunk));
    if (header.bonding) addBonds(arrays, *header.bonding);
    return encoded(arrays, header);
}

}  // namespace

Result<std::string> packBinary(const PackBuilder& builder, std::span<const PackMeshFile> meshes,
                               const TaskContext& task) {
    Pack header = builder.header(meshes);
    header.bonding = builder.bonding();
    return encoded(header, builder.whole(), builder.fragmentCount(), task.threads,
                   [&](BinaryArrays& arrays, std::uint32_t k) { addBinaryBody(arrays, k, builder.fragment(k)); });
}

Result<std::string> packBinary(const Pack& pack) {
    Pack header = pack;
    header.whole = {};
    header.fragments.clear();
    header.checksum.clear();
    return encoded(header, pack.whole, pack.fragments.size(), 1,
                   [&](BinaryArrays& arrays, std::uint32_t k) { addBinaryBody(arrays, k, pack.fragments[k]); });
}

}  // namespace rubble
