#include "core/fracture/pieces/MassTransfer.h"

#include "core/base/QuantityText.h"
#include "core/fracture/pieces/PieceWidth.h"

#include <algorithm>

namespace rubble {
namespace {

/// The receiver of the neighbour with the longest shared edge; kNone if no neighbour has a receiver yet.
std::uint32_t receiverBeyond(const Partition& partition, std::uint32_t piece,
                             const std::vector<std::uint32_t>& receivers) {
    std::uint32_t receiver = kNone;
    double longest = 0.0;
    for (const PieceContact& contact : contactsOf(partition, piece, 0.0)) {
        if (receivers[contact.piece] == kNone || contact.length <= longest) continue;
        receiver = receivers[contact.piece];
        longest = contact.length;
    }
    return receiver;
}

std::string receiverOf(const Partition& partition, std::uint32_t piece) {
    return partition.seedOfPiece[piece] == kNone ? "a neighbour" : cellText(partition, piece);
}

}  // namespace

std::vector<MassTransfer> massTransfersOf(const Partition& partition, std::span<const std::uint32_t> thin) {
    std::vector<std::uint32_t> receivers(partition.pieceCount());
    for (std::uint32_t piece = 0; piece < receivers.size(); ++piece) receivers[piece] = piece;
    std::vector<MassTransfer> transfers;
    for (const std::uint32_t piece : thin) {
        receivers[piece] = kNone;
        transfers.push_back({piece, kNone});
    }
    for (bool isAnyDecided = true; isAnyDecided;) {
        isAnyDecided = false;
        std::vector<MassTransfer> decided;
        for (const MassTransfer& transfer : transfers) {
            if (receivers[transfer.thin] == kNone)
                decided.push_back({transfer.thin, receiverBeyond(partition, transfer.thin, receivers)});
        }
        for (const MassTransfer& transfer : decided) {
            receivers[transfer.thin] = transfer.receiver;
            isAnyDecided |= transfer.receiver != kNone;
        }
    }
    for (MassTransfer& transfer : transfers) transfer.receiver = receivers[transfer.thin];
    return transfers;
}

Diagnostic massTransferReport(const Partition& partition, MassTransfer transfer) {
    const std::uint32_t seed = partition.seedOfPiece[transfer.thin];
    const Polygon outline = pieceOutline(partition, transfer.thin);
    Diagnostic report = diagnostic(DiagnosticCode::ThinPiece, {.seed = seed}, {}, area(outline));
    report.message = "A piece of " + cellText(partition, transfer.thin) + " is " +
                     quantityText(QuantityKind::Length, widthOf(outline)) + " wide, too thin for a hull";
    if (transfer.receiver == kNone) {
        report.message += "; it is omitted.";
        return report;
    }
    report.place.otherSeed = partition.seedOfPiece[transfer.receiver];
    report.message += "; its mass is transferred to " + receiverOf(partition, transfer.receiver) + ".";
    return report;
}

}  // namespace rubble
