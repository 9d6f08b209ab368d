#include "editor/panels/models/ProblemModel.h"

#include "editor/document/ShownText.h"
#include "editor/widgets/Icon.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"
#include "editor/widgets/numbers/NumberText.h"

#include <array>

namespace rubble {

QString textOf(DiagnosticCode kind) {
    switch (kind) {
        case DiagnosticCode::FaultyOutline: return ProblemModel::tr("Invalid outline");
        case DiagnosticCode::DuplicateSeed: return ProblemModel::tr("Duplicate seed");
        case DiagnosticCode::SeedWithoutCell: return ProblemModel::tr("Seed without a cell");
        case DiagnosticCode::LostOverride: return ProblemModel::tr("Override of a missing seed");
        case DiagnosticCode::LostPiece: return ProblemModel::tr("Edit of a missing fragment");
        case DiagnosticCode::LooseCut: return ProblemModel::tr("Dangling cut");
        case DiagnosticCode::NoRoom: return ProblemModel::tr("Too few seeds");
        case DiagnosticCode::NeedsPlane: return ProblemModel::tr("Layer without effect");
        case DiagnosticCode::Gap: return ProblemModel::tr("Gap");
        case DiagnosticCode::ThinPiece: return ProblemModel::tr("Thin fragment");
        case DiagnosticCode::VanishedPiece: return ProblemModel::tr("Fragment lost to the gap");
        case DiagnosticCode::Sliver: return ProblemModel::tr("Sliver");
        case DiagnosticCode::TinyPiece: return ProblemModel::tr("Tiny fragment");
        case DiagnosticCode::ManyHulls: return ProblemModel::tr("Many collision hulls");
        case DiagnosticCode::UnknownStrength: return ProblemModel::tr("Unknown strength");
        case DiagnosticCode::BeyondSpan: return ProblemModel::tr("Beyond the span");
        case DiagnosticCode::WeakBonds: return ProblemModel::tr("Weak bonds");
        default: break;  // notes are no problems
    }
    return {};
}

ProblemModel::ProblemModel(const Document& document, QObject* parent)
    : QAbstractTableModel(parent), m_document(document) {}

void ProblemModel::setProblems(std::vector<Diagnostic> problems, QStringList ids) {
    beginResetModel();
    m_problems = std::move(problems);
    m_ids = std::move(ids);
    endResetModel();
}

void ProblemModel::setUnits(const Units& units) {
    m_units = units;
    if (!m_problems.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
}

int ProblemModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_problems.size());
}

int ProblemModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant ProblemModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const bool isNumber = index.column() == kValue || index.column() == kLimit;
    switch (role) {
        case Qt::DisplayRole: return text(index.row(), index.column());
        case Qt::ToolTipRole:
            return toolTipText(tr("%1\nDouble-click to show the location").arg(text(index.row(), kText)));
        case Qt::DecorationRole:
            if (index.column() != kKind || problem(index.row()).code != DiagnosticCode::FaultyOutline) return {};
            return iconNamed("message-error");
        case kSortRole: return sortKey(problem(index.row()), index.column());
        case Qt::TextAlignmentRole:
            return static_cast<int>((isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
        default: return {};
    }
}

QVariant ProblemModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    const bool isNumber = section == kValue || section == kLimit;
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>((isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    if (role != Qt::DisplayRole) return {};
    const std::array titles = {tr("Kind"), tr("Location"), tr("Asset"), tr("Description"), tr("Value"), tr("Limit")};
    return titles[static_cast<std::size_t>(section)];
}

QVariant ProblemModel::sortKey(const Diagnostic& problem, int column) const {
    switch (column) {
        case kKind: return static_cast<int>(problem.code);
        case kAsset: return problem.place.asset;
        case kLocation:
            if (problem.place.index == kNone) return -1LL;
            return static_cast<qlonglong>(problem.place.layer) << 32 | problem.place.index;
        case kValue:
        case kLimit: return badness(problem);
        default: return QString::fromStdString(problem.message);
    }
}

QString ProblemModel::text(int row, int column) const {
    const Diagnostic& problem = this->problem(row);
    switch (column) {
        case kKind: return textOf(problem.code);
        case kAsset: {
            const Asset* asset = findAsset(m_document.project(), problem.place.asset);
            return asset ? nameText(asset->name) : QString();
        }
        case kLocation: return location(row);
        case kValue: return valueText(problem, problem.value);
        case kLimit: return problem.limit > 0.0 ? valueText(problem, problem.limit) : QString();
        case kText: return QString::fromStdString(problem.message);
        default: return {};
    }
}

QString ProblemModel::location(int row) const {
    const Diagnostic& problem = this->problem(row);
    if (const QString& id = m_ids[row]; !id.isEmpty()) return id;
    if (const auto seed = seedOf(problem.place)) return tr("seed %1").arg(QString::fromStdString(seed->text()));
    const std::optional<DiagnosticPlace::Point>& point = problem.place.point;
    if (!point) return {};
    const NumberFormat format = m_units.lengths();
    return withUnit(tr("%1, %2").arg(roundedText(point->x, format), roundedText(point->y, format)), format);
}

QString ProblemModel::valueText(const Diagnostic& problem, double value) const {
    switch (problem.code) {
        case DiagnosticCode::Sliver: return tr("%1 : 1").arg(roundedText(value, {}));
        case DiagnosticCode::TinyPiece: return localizedQuantity(QuantityKind::Volume, value, m_units);
        case DiagnosticCode::ManyHulls: return tr("%Ln hull(s)", nullptr, static_cast<int>(value));
        case DiagnosticCode::NoRoom: return tr("%Ln seed(s)", nullptr, static_cast<int>(value));
        case DiagnosticCode::BeyondSpan: return localizedQuantity(QuantityKind::Length, value, m_units);
        case DiagnosticCode::WeakBonds: return localizedQuantity(QuantityKind::Force, value, m_units);
        case DiagnosticCode::UnknownStrength: return localizedQuantity(QuantityKind::Impulse, value);
        case DiagnosticCode::Gap:
        case DiagnosticCode::ThinPiece:
        case DiagnosticCode::VanishedPiece: return localizedQuantity(QuantityKind::Area, value, m_units);
        default: return {};
    }
}

}  // namespace rubble

#include "moc_ProblemModel.cpp"
