#include "core/fracture/Report.h"

namespace rubble {

const char* nameOf(ReportCode code) {
    switch (code) {
        case ReportCode::DuplicateSeed: return "DuplicateSeed";
        case ReportCode::SeedWithoutCell: return "SeedWithoutCell";
        case ReportCode::SplitCell: return "SplitCell";
        case ReportCode::ThinPiece: return "ThinPiece";
        case ReportCode::LostOverride: return "LostOverride";
        case ReportCode::NoRoom: return "NoRoom";
        case ReportCode::Gap: return "Gap";
        case ReportCode::MergedPiece: return "MergedPiece";
        case ReportCode::DroppedSeed: return "DroppedSeed";
        case ReportCode::LostPiece: return "LostPiece";
        case ReportCode::VanishedPiece: return "VanishedPiece";
        case ReportCode::LooseCut: return "LooseCut";
    }
    return "";
}

}  // namespace rubble
