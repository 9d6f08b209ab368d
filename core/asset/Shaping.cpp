#include "core/asset/Shaping.h"

#include "core/asset/Quantities.h"
#include "core/base/MessageText.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

namespace rubble {
namespace {

/// Carries out edits on the pieces of one breaking.
class PieceEditing {
public:
    PieceEditing(Partition&& partition, const Seeds& seeds, Vec2 offset)
        : m_draft(std::move(partition)), m_seeds(seeds), m_offset(offset) {
        for (std::uint32_t piece = 0; piece < m_draft.count(); ++piece) takeName(piece);
    }

    void apply(const FragmentMerge& merge) {
        const std::uint32_t into = find(merge.into);
        if (into == kNone) return lost(merge.into, "is not there; nothing is merged into it.");
        std::vector<std::uint32_t> waiting;
        std::vector<FragmentPath> names;
        for (const FragmentPath& path : merge.merged) {
            const std::uint32_t piece = find(path);
            if (piece == kNone) {
                lost(path, "is not there; it is not merged into " + merge.into + ".");
            } else if (piece != into) {
                waiting.push_back(piece);
                names.push_back(path);
            }
        }
        mergeTouching(into, waiting);
        for (std::size_t k = 0; k < waiting.size(); ++k) {
            if (waiting[k] != kNone) lost(names[k], "does not touch " + merge.into + "; it is not merged into it.");
        }
    }

    void apply(const FragmentSplit& split) {
        const std::uint32_t piece = find(split.fragment), firstNew = m_draft.count();
        if (piece == kNone) return lost(split.fragment, "is not there; it is not split.");
        const Line line{split.line.point - m_offset, split.line.direction};
        if (m_draft.split(piece, line) == 1) return lost(split.fragment, "is missed by the line that is to split it.");
        takeName(piece);
        for (std::uint32_t part = firstNew; part < m_draft.count(); ++part) takeName(part);
    }

    Partition finished() && {
        Partition partition = std::move(m_draft).finished();
        partition.reports.insert(partition.reports.end(), m_reports.begin(), m_reports.end());
        return partition;
    }

private:
    std::uint32_t find(const FragmentPath& path) const {
        const std::string name = path.substr(path.rfind('/') + 1);
        const auto found = m_pieces.find(name);
        if (found == m_pieces.end() || !m_draft.isThere(found->second)) return kNone;
        return m_draft.nameOf(found->second, m_seeds.ids) == name ? found->second : kNone;
    }

    void takeName(std::uint32_t piece) { m_pieces[m_draft.nameOf(piece, m_seeds.ids)] = piece; }

    /// Merges those that touch, and those that touch them; the others stay in the list.
    void mergeTouching(std::uint32_t into, std::vector<std::uint32_t>& waiting) {
        std::vector<std::uint32_t> receivers(m_draft.count());
        std::iota(receivers.begin(), receivers.end(), 0u);
        std::vector<std::uint32_t> group{into};
        for (std::size_t member = 0; member < group.size(); ++member) {
            for (std::uint32_t& piece : waiting) {
                if (piece == kNone || !m_draft.areNeighbours(group[member], piece)) continue;
                receivers[piece] = into;
                group.push_back(piece);
                piece = kNone;
            }
        }
        if (group.size() > 1) m_draft.merge(receivers);
    }

    void lost(const FragmentPath& path, const std::string& rest) {
        m_reports.push_back({ReportCode::LostPiece, kNone, kNone, 0.0, "The piece " + path + " " + rest});
    }

    PieceDraft m_draft;
    const Seeds& m_seeds;
    Vec2 m_offset;
    std::unordered_map<std::string, std::uint32_t> m_pieces;  // by name; some are merged or renamed meanwhile
    std::vector<Report> m_reports;
};

}  // namespace

FragmentPath placeOf(const FragmentEdit& edit) {
    const auto* merge = std::get_if<FragmentMerge>(&edit);
    return parentOf(merge ? merge->into : std::get<FragmentSplit>(edit).fragment);
}

std::optional<std::string> verifyShaping(const Shaping& shaping) {
    if (auto fault = verifySmallPieces(shaping.smallPieces)) return fault;
    const Roughness& roughness = shaping.roughness;
    if (auto fault = quantityFault("The shape of pieces", {{"gap", shaping.gap, Range::ZeroOrAbove},
                                                           {"roughness", roughness.amplitude, Range::ZeroOrAbove},
                                                           {"frequency", roughness.frequency, Range::AboveZero}})) {
        return fault;
    }
    if (roughness.octaves >= 1 && roughness.octaves <= Roughness::kMostOctaves) return std::nullopt;
    return "The roughness has " + std::to_string(roughness.octaves) + " octaves, but it must have from 1 to " +
           std::to_string(Roughness::kMostOctaves) + ".";
}

std::optional<std::string> verifyEdit(const FragmentEdit& edit) {
    const auto pathFault = [](const FragmentPath& path) -> std::optional<std::string> {
        if (isPath(path)) return std::nullopt;
        return "\"" + path + "\" names no fragment.";
    };
    if (const auto* split = std::get_if<FragmentSplit>(&edit)) {
        if (auto fault = pathFault(split->fragment)) return fault;
        const Line& line = split->line;
        const double length = std::abs(line.direction.x) + std::abs(line.direction.y);
        const bool isLine =
            std::isfinite(line.point.x) && std::isfinite(line.point.y) && length > 0.0 && length < 1e300;
        if (isLine) return std::nullopt;
        return "The line that splits fragment " + split->fragment + " has no direction, or is not finite.";
    }
    const auto& merge = std::get<FragmentMerge>(edit);
    if (auto fault = pathFault(merge.into)) return fault;
    for (const FragmentPath& path : merge.merged) {
        if (auto fault = pathFault(path)) return fault;
        if (parentOf(path) != parentOf(merge.into) || path == merge.into) {
            return "Fragment " + path + " cannot be merged into " + merge.into + ": they are not pieces of the same.";
        }
    }
    return std::nullopt;
}

Partition editedPieces(Partition partition, const Seeds& seeds, const std::vector<FragmentEdit>& edits,
                       const FragmentPath& place, Vec2 offset) {
    const auto isHere = [&](const FragmentEdit& edit) { return placeOf(edit) == place; };
    if (std::ranges::none_of(edits, isHere)) return partition;
    PieceEditing editing(std::move(partition), seeds, offset);
    for (const FragmentEdit& edit : edits) {
        if (isHere(edit)) std::visit([&](const auto& done) { editing.apply(done); }, edit);
    }
    return std::move(editing).finished();
}

}  // namespace rubble
