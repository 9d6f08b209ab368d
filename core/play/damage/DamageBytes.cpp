#include "core/play/damage/DamageBytes.h"

#include "core/base/Assert.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rubble {
namespace {

constexpr std::string_view kMagic = "RDMG";
constexpr std::size_t kHeader = 4 + 1 + 1 + 1 + 16 + 4;  // magic, version, kind, whether there is a cut, bake, count
constexpr std::size_t kCut = 24, kHeight = 8;            // a cut in the plane, and what one of a mesh has more
constexpr std::size_t kPartialCount = 4, kPartial = 4;   // the number of damaged bonds, and each: 3 of its index, 1
constexpr std::size_t kMaxBonds = std::size_t{1} << 24;
constexpr std::size_t kChecksum = 8;

void add(std::string& bytes, std::uint64_t value, int size) {
    for (int k = 0; k < size; ++k) bytes.push_back(static_cast<char>(value >> (8 * k)));
}

/// The little-endian number of `size` bytes from `at`.
std::uint64_t numberAt(std::string_view bytes, std::size_t at, std::size_t size) {
    std::uint64_t value = 0;
    for (std::size_t k = size; k-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
    return value;
}

Error malformed(const std::string& what) { return {ErrorCode::BadInput, "The damage cannot be read: " + what + "."}; }

/// What a damage has of a cut. Written to files: values never change.
enum class CutKind : std::uint8_t { None = 0, InPlane = 1, WithHeight = 2 };

CutKind kindOf(const std::optional<ImpactCut>& cut) {
    if (!cut) return CutKind::None;
    return cut->isInPlane() ? CutKind::InPlane : CutKind::WithHeight;
}

std::size_t sizeOf(CutKind kind) {
    if (kind == CutKind::None) return 0;
    return kind == CutKind::InPlane ? kCut : kCut + kHeight;
}

std::optional<ImpactCut> cutAt(std::string_view bytes, std::size_t at, CutKind kind) {
    if (kind == CutKind::None) return std::nullopt;
    const auto coordinate = [&](std::size_t place) { return std::bit_cast<double>(numberAt(bytes, at + place, 8)); };
    return ImpactCut{.point = {coordinate(0), coordinate(8)},
                     .number = numberAt(bytes, at + 16, 8),
                     .height = kind == CutKind::WithHeight ? coordinate(kCut) : 0.0};
}

/// Why a cut cannot be one.
std::optional<std::string> cutFault(const ImpactCut& cut, CutKind kind) {
    if (!std::isfinite(cut.point.x) || !std::isfinite(cut.point.y) || !std::isfinite(cut.height))
        return "the point of its cut is not finite";
    if (kind == CutKind::WithHeight && cut.isInPlane()) return "the height of its cut is zero";
    return std::nullopt;
}

/// Checks size, magic, version and checksum.
Status checkBytes(std::string_view bytes) {
    if (bytes.size() < kHeader + kChecksum) return malformed("it has " + std::to_string(bytes.size()) + " bytes only");
    if (!bytes.starts_with(kMagic)) return malformed("it does not start with " + std::string(kMagic));
    const std::string_view content = bytes.substr(0, bytes.size() - kChecksum);
    if (contentHash(content).low != numberAt(bytes, content.size(), kChecksum)) {
        return malformed("its checksum does not fit, so bytes were changed; send it again");
    }
    const std::uint64_t version = numberAt(bytes, 4, 1), kind = numberAt(bytes, 5, 1);
    if (version == 0 || version > kDamageVersion) {
        return Error{ErrorCode::Unsupported, "The damage is of version " + std::to_string(version) +
                                                 ", but only version " + std::to_string(kDamageVersion) +
                                                 " can be read."};
    }
    if (kind < static_cast<std::uint64_t>(DamageKind::Fractures) ||
        kind > static_cast<std::uint64_t>(DamageKind::Bonds)) {
        return Error{ErrorCode::Unsupported, "The damage is of the unknown kind " + std::to_string(kind) + "."};
    }
    return success();
}

/// The size that a damage must have whose damaged bonds begin at `partial`.
Result<std::size_t> sizeOf(std::string_view bytes, DamageKind kind, std::size_t partial) {
    if (kind == DamageKind::Fractures) return partial + kChecksum;
    if (bytes.size() < partial + kPartialCount + kChecksum) return malformed("it ends before its damaged bonds");
    return partial + kPartialCount + kPartial * numberAt(bytes, partial, kPartialCount) + kChecksum;
}

/// Reads the damaged bonds that hold; false if one is not as damageBytes() writes it.
bool readPartial(std::string_view bytes, std::size_t at, InstanceDamage& damage) {
    const std::uint64_t count = numberAt(bytes, at, kPartialCount);
    for (std::uint64_t k = 0; k < count; ++k) {
        const std::size_t place = at + kPartialCount + kPartial * k;
        const auto bond = static_cast<std::uint32_t>(numberAt(bytes, place, 3));
        const auto one = static_cast<std::uint8_t>(numberAt(bytes, place + 3, 1));
        const bool isAscending = damage.partial.empty() || damage.partial.rbegin()->first < bond;
        if (!isAscending || bond >= damage.broken.size() || damage.broken[bond] || one == 0 || one == 255) return false;
        damage.partial[bond] = one;
    }
    return true;
}

}  // namespace

std::string damageBytes(const InstanceDamage& damage) {
    std::string bytes(kMagic);
    add(bytes, kDamageVersion, 1);
    add(bytes, static_cast<std::uint64_t>(damage.kind), 1);
    add(bytes, static_cast<std::uint64_t>(kindOf(damage.cut)), 1);
    add(bytes, damage.bake.high, 8);
    add(bytes, damage.bake.low, 8);
    add(bytes, damage.broken.size(), 4);
    if (damage.cut) {
        add(bytes, std::bit_cast<std::uint64_t>(damage.cut->point.x), 8);
        add(bytes, std::bit_cast<std::uint64_t>(damage.cut->point.y), 8);
        add(bytes, damage.cut->number, 8);
        if (kindOf(damage.cut) == CutKind::WithHeight) add(bytes, std::bit_cast<std::uint64_t>(damage.cut->height), 8);
    }
    for (std::size_t first = 0; first < damage.broken.size(); first += 8) {
        unsigned octet = 0;
        for (std::size_t k = first; k < std::min(first + 8, damage.broken.size()); ++k) {
            octet |= (damage.broken[k] ? 1u : 0u) << (k - first);
        }
        add(bytes, octet, 1);
    }
    if (damage.kind == DamageKind::Bonds) {
        RUBBLE_ASSERT(damage.broken.size() <= kMaxBonds);
        add(bytes, damage.partial.size(), kPartialCount);
        for (const auto& [bond, one] : damage.partial) add(bytes, std::uint64_t{one} << 24 | bond, kPartial);
    }
    add(bytes, contentHash(bytes).low, kChecksum);
    return bytes;
}

Result<InstanceDamage> damageOfBytes(std::string_view bytes) {
    if (const Status checked = checkBytes(bytes); !checked) return checked.error();
    const auto cutKind = static_cast<CutKind>(numberAt(bytes, 6, 1));
    const std::uint64_t count = numberAt(bytes, 23, 4);
    if (cutKind > CutKind::WithHeight) return malformed("its cut is neither there nor absent");
    const auto kind = static_cast<DamageKind>(numberAt(bytes, 5, 1));
    if (kind == DamageKind::Bonds && count > kMaxBonds) {
        return malformed("it has " + std::to_string(count) + " bonds, but " + std::to_string(kMaxBonds) +
                         " are the most");
    }
    const std::size_t bits = kHeader + sizeOf(cutKind);
    const std::size_t partial = bits + (count + 7) / 8;
    const Result<std::size_t> size = sizeOf(bytes, kind, partial);
    if (!size) return size.error();
    if (bytes.size() != *size) {
        return malformed("of " + std::to_string(count) + (kind == DamageKind::Bonds ? " bonds" : " fractures") +
                         " it must have " + std::to_string(*size) + " bytes, but it has " +
                         std::to_string(bytes.size()));
    }
    InstanceDamage damage{
        .kind = kind, .bake = {numberAt(bytes, 7, 8), numberAt(bytes, 15, 8)}, .broken = std::vector<bool>(count)};
    damage.cut = cutAt(bytes, kHeader, cutKind);
    if (const auto fault = damage.cut ? cutFault(*damage.cut, cutKind) : std::nullopt) return malformed(*fault);
    for (std::size_t k = 0; k < count; ++k) damage.broken[k] = (numberAt(bytes, bits + k / 8, 1) >> (k % 8) & 1) != 0;
    if (count % 8 != 0 && numberAt(bytes, bits + count / 8, 1) >> (count % 8) != 0) {
        return malformed("it has bits beyond its last fracture");
    }
    if (kind == DamageKind::Bonds && !readPartial(bytes, partial, damage)) {
        return malformed("a damaged bond is broken, out of order or does not exist");
    }
    return damage;
}

}  // namespace rubble
