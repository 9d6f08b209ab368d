#include "editor/panels/models/OutlineModel.h"

#include "core/asset/project/OutlineEdit.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/widgets/numbers/NumberText.h"

#include <algorithm>

namespace rubble {

namespace {

constexpr std::size_t kMinPoints = 3;

Ring& ringOf(Polygon& outline, std::size_t ring) { return ring == 0 ? outline.outer : outline.holes[ring - 1]; }
const Ring& ringOf(const Polygon& outline, std::size_t ring) {
    return ring == 0 ? outline.outer : outline.holes[ring - 1];
}

/// A clockwise square about a point.
Ring squareHole(Vec2 centre, double side) {
    const double half = side / 2.0;
    return {centre + Vec2{-half, -half}, centre + Vec2{-half, half}, centre + Vec2{half, half},
            centre + Vec2{half, -half}};
}

}  // namespace

OutlineModel::OutlineModel(Document& document, QObject* parent) : QAbstractTableModel(parent), m_document(document) {}

void OutlineModel::setRing(Id asset, std::size_t ring) {
    m_asset = asset;
    m_ring = ring;
    refresh();
}

void OutlineModel::setUnits(const Units& units) {
    m_units = units;
    if (!m_points.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, 1));
    emit headerDataChanged(Qt::Horizontal, 0, 1);
}

void OutlineModel::refresh() {
    const Asset* shown = asset();
    if (shown && m_ring > shown->prism().outline.holes.size()) m_ring = 0;
    Ring points = shown ? ringOf(shown->prism().outline, m_ring) : Ring{};
    if (points.size() != m_points.size()) {
        beginResetModel();
        m_points = std::move(points);
        endResetModel();
    } else if (points != m_points) {
        m_points = std::move(points);
        emit dataChanged(index(0, 0), index(rowCount() - 1, 1));
    }
}

bool OutlineModel::push(const QString& text, const std::function<void(Ring&)>& change) {
    const Asset* shown = asset();
    if (!shown) return false;
    Polygon outline = shown->prism().outline;
    change(ringOf(outline, m_ring));
    return pushOutline(text, std::move(outline));
}

bool OutlineModel::pushOutline(const QString& text, Polygon outline) {
    const Result<Prism> valid = validated(Prism{outline, asset()->prism().depth});
    if (!valid) {
        emit refused(QString::fromStdString(valid.error().message));
        return false;
    }
    return m_document.push(modify(text, withOutline(*asset(), std::move(outline))));
}

void OutlineModel::insertAfter(int row) {
    const auto from = static_cast<std::size_t>(row);
    push(tr("Add Point"), [&](Ring& ring) {
        const Vec2 middle = (ring[from] + ring[(from + 1) % ring.size()]) / 2.0;
        ring.insert(ring.begin() + row + 1, middle);
    });
}

void OutlineModel::removePoints(std::vector<int> rows) {
    if (rows.empty()) return;
    if (m_points.size() < kMinPoints + rows.size())
        return emit refused(tr("An outline needs at least three points. Delete fewer."));
    std::ranges::sort(rows, std::greater{});
    push(tr("Delete %n Point(s)", nullptr, static_cast<int>(rows.size())), [&](Ring& ring) {
        for (const int row : rows) ring.erase(ring.begin() + row);
    });
}

bool OutlineModel::addHole() {
    const Asset* shown = asset();
    if (!shown) return false;
    const Vec2 size = boundsOf(shown->prism().outline.outer).size();
    for (const double part : {0.2, 0.1, 0.05}) {
        Asset changed = *shown;
        const Vec2 centre = centroid(shown->prism().outline);
        changed.prism().outline.holes.push_back(squareHole(centre, part * std::min(size.x, size.y)));
        if (!validated(changed.prism())) continue;
        return pushOutline(tr("Add Hole"), std::move(changed.prism().outline));
    }
    emit refused(tr("There is no room for a hole at the centre of the outline. Draw the hole in the canvas."));
    return false;
}

void OutlineModel::removeHole() {
    const Asset* shown = asset();
    if (!shown || m_ring == 0) return;
    Polygon outline = shown->prism().outline;
    outline.holes.erase(outline.holes.begin() + static_cast<std::ptrdiff_t>(m_ring) - 1);
    pushOutline(tr("Delete Hole"), std::move(outline));
}

int OutlineModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_points.size());
}

int OutlineModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : 2; }

QVariant OutlineModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {};
    const double value = m_points[static_cast<std::size_t>(index.row())][index.column()];
    switch (role) {
        case Qt::DisplayRole: return roundedText(value, m_units.lengths());
        case Qt::ToolTipRole: return withUnit(exactText(value, m_units.lengths(), {}), m_units.lengths());
        case Qt::EditRole: return value;
        case Qt::TextAlignmentRole: return QVariant(Qt::AlignRight | Qt::AlignVCenter);
        default: return {};
    }
}

bool OutlineModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || !index.isValid()) return false;
    return push(tr("Move Point"),
                [&](Ring& ring) { ring[static_cast<std::size_t>(index.row())][index.column()] = value.toDouble(); });
}

QVariant OutlineModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role != Qt::DisplayRole) return {};
    if (orientation == Qt::Vertical) return section;  // counted from 0, as in error messages
    return QString("%1 (%2)").arg(section == 0 ? tr("x") : tr("y"), m_units.lengths().unit);
}

Qt::ItemFlags OutlineModel::flags(const QModelIndex& index) const {
    return QAbstractTableModel::flags(index) | Qt::ItemIsEditable;
}

}  // namespace rubble

#include "moc_OutlineModel.cpp"
