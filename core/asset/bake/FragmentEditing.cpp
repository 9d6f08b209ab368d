#include "core/asset/bake/FragmentEditing.h"

#include "core/fracture/pieces/PieceDraft.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace rubble {
namespace {

/// Applies edits to the pieces of one fracture.
class PieceEditor {
public:
    PieceEditor(Partition&& partition, const Seeds& seeds, Vec2 offset)
        : m_draft(std::move(partition)), m_seeds(seeds), m_offset(offset) {
        for (std::uint32_t piece = 0; piece < m_draft.count(); ++piece) registerName(piece);
    }

    void apply(const FragmentMerge& merge) {
        const std::uint32_t into = find(merge.into);
        if (into == kNone) return reportLost(merge.into, "does not exist; nothing is merged into it.");
        std::vector<std::uint32_t> pending;
        std::vector<FragmentPath> names;
        for (const FragmentPath& path : merge.merged) {
            const std::uint32_t piece = find(path);
            if (piece == kNone) {
                reportLost(path, "does not exist; it is not merged into " + merge.into + ".");
            } else if (piece != into) {
                pending.push_back(piece);
                names.push_back(path);
            }
        }
        mergeTouching(into, pending);
        for (std::size_t k = 0; k < pending.size(); ++k) {
            if (pending[k] != kNone) reportLost(names[k], "does not touch " + merge.into + "; they are not merged.");
        }
    }

    void apply(const FragmentSplit& split) {
        const std::uint32_t piece = find(split.fragment), firstNew = m_draft.count();
        if (piece == kNone) return reportLost(split.fragment, "does not exist; it is not split.");
        const Line line{split.line.point - m_offset, split.line.direction};
        if (m_draft.split(piece, line) == 1)
            return reportLost(split.fragment, "does not intersect its split line; it is not split.");
        registerName(piece);
        for (std::uint32_t part = firstNew; part < m_draft.count(); ++part) registerName(part);
    }

    Partition finished() && {
        Partition partition = std::move(m_draft).finished();
        partition.diagnostics.insert(partition.diagnostics.end(), m_reports.begin(), m_reports.end());
        return partition;
    }

private:
    std::uint32_t find(const FragmentPath& path) const {
        const std::string name = path.substr(path.rfind('/') + 1);
        const auto found = m_pieces.find(name);
        if (found == m_pieces.end() || !m_draft.exists(found->second)) return kNone;
        return m_draft.nameOf(found->second, m_seeds.ids) == name ? found->second : kNone;
    }

    void registerName(std::uint32_t piece) { m_pieces[m_draft.nameOf(piece, m_seeds.ids)] = piece; }

    /// Merges the pieces that are connected to `into`, directly or through each other; the others stay in the list.
    void mergeTouching(std::uint32_t into, std::vector<std::uint32_t>& pending) {
        std::vector<std::uint32_t> receivers(m_draft.count());
        std::iota(receivers.begin(), receivers.end(), 0u);
        std::vector<std::uint32_t> group{into};
        for (std::size_t member = 0; member < group.size(); ++member) {
            for (std::uint32_t& piece : pending) {
                if (piece == kNone || !m_draft.areNeighbours(group[member], piece)) continue;
                receivers[piece] = into;
                group.push_back(piece);
                piece = kNone;
            }
        }
        if (group.size() > 1) m_draft.merge(receivers);
    }

    void reportLost(const FragmentPath& path, const std::string& rest) {
        m_reports.push_back(diagnostic(DiagnosticCode::LostPiece, {.path = path}, "Fragment " + path + " " + rest));
    }

    PieceDraft m_draft;
    const Seeds& m_seeds;
    Vec2 m_offset;
    std::unordered_map<std::string, std::uint32_t> m_pieces;  // by name; entries of merged or renamed pieces are stale
    std::vector<Diagnostic> m_reports;
};

}  // namespace

Partition editedPieces(Partition partition, const Seeds& seeds, const std::vector<FragmentEdit>& edits,
                       const FragmentPath& parent, Vec2 offset) {
    const auto isHere = [&](const FragmentEdit& edit) { return parentOf(edit) == parent; };
    if (std::ranges::none_of(edits, isHere)) return partition;
    PieceEditor editor(std::move(partition), seeds, offset);
    for (const FragmentEdit& edit : edits) {
        if (isHere(edit)) std::visit([&](const auto& one) { editor.apply(one); }, edit);
    }
    return std::move(editor).finished();
}

}  // namespace rubble
