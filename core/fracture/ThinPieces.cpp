#include "core/fracture/ThinPieces.h"

#include "core/base/MessageText.h"

#include <algorithm>

namespace rubble {
namespace {

/// The owner across the longest shared edge, kNone where no neighbour has an owner yet.
std::uint32_t ownerAcross(const Partition& partition, std::uint32_t piece, const std::vector<std::uint32_t>& owners) {
    std::uint32_t owner = kNone;
    double longest = 0.0;
    for (const PieceContact& contact : contactsOf(partition, piece, 0.0)) {
        if (owners[contact.piece] == kNone || contact.length <= longest) continue;
        owner = owners[contact.piece];
        longest = contact.length;
    }
    return owner;
}

std::string cellOf(const Partition& partition, std::uint32_t piece) {
    if (partition.seedOfPiece[piece] == kNone) return "the outline";
    return "the cell of seed " + std::to_string(partition.seedOfPiece[piece]);
}

std::string receiverOf(const Partition& partition, std::uint32_t piece) {
    return partition.seedOfPiece[piece] == kNone ? "a neighbour" : cellOf(partition, piece);
}

}  // namespace

double widthOf(const Polygon& polygon) { return widthOf(area(polygon), perimeter(polygon)); }

std::vector<ThinPieceGift> thinPieceGifts(const Partition& partition, std::span<const std::uint32_t> thin) {
    std::vector<std::uint32_t> owners(partition.pieceCount());
    for (std::uint32_t piece = 0; piece < owners.size(); ++piece) owners[piece] = piece;
    std::vector<ThinPieceGift> gifts;
    for (const std::uint32_t piece : thin) {
        owners[piece] = kNone;
        gifts.push_back({piece, kNone});
    }
    for (bool isAnyDecided = true; isAnyDecided;) {
        isAnyDecided = false;
        std::vector<ThinPieceGift> decided;
        for (const ThinPieceGift& gift : gifts) {
            if (owners[gift.thin] == kNone) decided.push_back({gift.thin, ownerAcross(partition, gift.thin, owners)});
        }
        for (const ThinPieceGift& gift : decided) {
            owners[gift.thin] = gift.receiver;
            isAnyDecided |= gift.receiver != kNone;
        }
    }
    for (ThinPieceGift& gift : gifts) gift.receiver = owners[gift.thin];
    return gifts;
}

Report thinPieceReport(const Partition& partition, ThinPieceGift gift) {
    const std::uint32_t seed = partition.seedOfPiece[gift.thin];
    const Polygon outline = pieceOutline(partition, gift.thin);
    Report report{ReportCode::ThinPiece, seed, kNone, area(outline), {}};
    report.message = "A piece of " + cellOf(partition, gift.thin) + " is " + messageText(widthOf(outline)) +
                     " m wide, too thin for a hull";
    if (gift.receiver == kNone) {
        report.message += "; it is left out.";
        return report;
    }
    report.of = partition.seedOfPiece[gift.receiver];
    report.message += "; its mass goes to " + receiverOf(partition, gift.receiver) + ".";
    return report;
}

}  // namespace rubble
