#include "editor/panels/ProblemModel.h"

#include "editor/icons/Icon.h"
#include "editor/panels/LocalNumber.h"

#include <QLocale>

#include <algorithm>
#include <array>
#include <numeric>

namespace rubble {

namespace {

constexpr int kDigits = 3;  // of figures

}  // namespace

QString textOf(ProblemKind kind) {
    switch (kind) {
        case ProblemKind::FaultyOutline: return ProblemModel::tr("Faulty outline");
        case ProblemKind::DuplicateSeed: return ProblemModel::tr("Equal seed");
        case ProblemKind::SeedWithoutCell: return ProblemModel::tr("Seed without a cell");
        case ProblemKind::LostOverride: return ProblemModel::tr("Change without a seed");
        case ProblemKind::LostPiece: return ProblemModel::tr("Change without a piece");
        case ProblemKind::LooseCut: return ProblemModel::tr("Cut that parts nothing");
        case ProblemKind::NoRoom: return ProblemModel::tr("No room for seeds");
        case ProblemKind::Gap: return ProblemModel::tr("Gap");
        case ProblemKind::ThinPiece: return ProblemModel::tr("Thin piece");
        case ProblemKind::VanishedPiece: return ProblemModel::tr("Lost to the gap");
        case ProblemKind::Sliver: return ProblemModel::tr("Sliver");
        case ProblemKind::TinyPiece: return ProblemModel::tr("Tiny piece");
        case ProblemKind::ManyHulls: return ProblemModel::tr("Many hulls");
        case ProblemKind::UnknownStrength: return ProblemModel::tr("Unknown strength");
    }
    return {};
}

ProblemModel::ProblemModel(const Document& document, QObject* parent)
    : QAbstractTableModel(parent), m_document(document) {}

void ProblemModel::setProblems(std::vector<Problem> problems, QStringList ids) {
    beginResetModel();
    m_problems = std::move(problems);
    m_ids = std::move(ids);
    arrange();
    endResetModel();
}

void ProblemModel::setUnits(const Units& units) {
    m_units = units;
    if (!m_rows.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
}

int ProblemModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int ProblemModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant ProblemModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const std::size_t problem = m_rows[static_cast<std::size_t>(index.row())];
    const bool isNumber = index.column() == kFigure || index.column() == kLimit;
    switch (role) {
        case Qt::DisplayRole: return text(problem, index.column());
        case Qt::ToolTipRole: return tr("%1\nDouble click or Enter: show where").arg(text(problem, kText));
        case Qt::DecorationRole:
            if (index.column() != kWhat || m_problems[problem].kind != ProblemKind::FaultyOutline) return {};
            return iconNamed("message-error");
        case Qt::TextAlignmentRole:
            return static_cast<int>((isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
        default: return {};
    }
}

QVariant ProblemModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    const bool isNumber = section == kFigure || section == kLimit;
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>((isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    if (role != Qt::DisplayRole) return {};
    const std::array titles = {tr("What"), tr("Where"), tr("Asset"), tr("In words"), tr("Figure"), tr("Limit")};
    return titles[static_cast<std::size_t>(section)];
}

void ProblemModel::sort(int column, Qt::SortOrder order) {
    beginResetModel();
    m_sortColumn = column;
    m_sortOrder = order;
    arrange();
    endResetModel();
}

void ProblemModel::arrange() {
    m_rows.resize(m_problems.size());
    std::iota(m_rows.begin(), m_rows.end(), std::size_t{0});
    const auto isBefore = [&](std::size_t a, std::size_t b) {
        const Problem &left = m_problems[a], &right = m_problems[b];
        switch (m_sortColumn) {
            case kWhat: return left.kind < right.kind;
            case kAsset: return left.asset < right.asset;
            case kWhere: return left.seed < right.seed;
            case kFigure:
            case kLimit: return left.badness() < right.badness();
            default: return left.message < right.message;
        }
    };
    std::ranges::stable_sort(m_rows, [&](std::size_t a, std::size_t b) {
        return m_sortOrder == Qt::AscendingOrder ? isBefore(a, b) : isBefore(b, a);
    });
}

QString ProblemModel::text(std::size_t problem, int column) const {
    const Problem& told = m_problems[problem];
    switch (column) {
        case kWhat: return textOf(told.kind);
        case kAsset: {
            const Asset* asset = findAsset(m_document.project(), told.asset);
            return asset ? QString::fromStdString(asset->name) : QString();
        }
        case kWhere: return where(problem);
        case kFigure: return figure(told, told.value);
        case kLimit: return told.limit > 0.0 ? figure(told, told.limit) : QString();
        case kText: return QString::fromStdString(told.message);
        default: return {};
    }
}

QString ProblemModel::where(std::size_t problem) const {
    const Problem& told = m_problems[problem];
    if (const QString& id = m_ids[static_cast<qsizetype>(problem)]; !id.isEmpty()) return id;
    if (told.seed) return tr("seed %1").arg(QString::fromStdString(told.seed->text()));
    if (!told.where) return {};
    const QLocale locale;
    return tr("%1, %2 m").arg(locale.toString(told.where->x, 'f', 3), locale.toString(told.where->y, 'f', 3));
}

QString ProblemModel::figure(const Problem& problem, double value) const {
    const QLocale locale;
    switch (problem.kind) {
        case ProblemKind::Sliver: return tr("%1 : 1").arg(roundedText(value, kDigits, {}, locale));
        case ProblemKind::TinyPiece:
            return withUnit(roundedText(value, kDigits, m_units.volumes(), locale), m_units.volumes());
        case ProblemKind::ManyHulls: return tr("%L1 hulls").arg(static_cast<int>(value));
        case ProblemKind::NoRoom: return tr("%L1 seeds").arg(static_cast<int>(value));
        case ProblemKind::UnknownStrength:
            return withUnit(roundedText(value, kDigits, {tr("N·s")}, locale), {tr("N·s")});
        case ProblemKind::Gap:
        case ProblemKind::ThinPiece:
        case ProblemKind::VanishedPiece:
            return withUnit(roundedText(value, kDigits, m_units.areas(), locale), m_units.areas());
        default: return {};
    }
}

}  // namespace rubble
