#include "editor/canvas/tools/BrushTool.h"

#include "core/fracture/layer/SeedId.h"
#include "core/fracture/pattern/SeedEdits.h"
#include "core/fracture/sampling/DensityArea.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/widgets/input/BrushRing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace rubble {

namespace {

constexpr double kStrengthStep = 0.1;
constexpr double kDenserThanPieces = 4.0;  // fragments half as long and wide where a new picture is densest
constexpr double kFewestPieces = 20.0;     // assumed of an outline in a few pieces
constexpr int kMaxAlpha = 150;             // of the image over the cells, of 255

/// The grey value of the highest density; erasing, of the lowest.
double valueOf(DenseWhere dense, bool isErasing) { return (dense == DenseWhere::Bright) != isErasing ? 1.0 : 0.0; }

/// The density of an image as the opacity of a colour.
QImage overlayOf(const GreyImage& image, DenseWhere dense, const QColor& colour) {
    const double white = image.white();
    const auto coloured = [&](double density) {
        return qPremultiply(qRgba(colour.red(), colour.green(), colour.blue(), static_cast<int>(kMaxAlpha * density)));
    };
    std::vector<QRgb> colours(static_cast<std::size_t>(white) + 1);  // of each grey
    for (std::size_t grey = 0; grey < colours.size(); ++grey) {
        const double bright = static_cast<double>(grey) / white;
        colours[grey] = coloured(dense == DenseWhere::Bright ? bright : 1.0 - bright);
    }
    QImage overlay(static_cast<int>(image.width), static_cast<int>(image.height), QImage::Format_ARGB32_Premultiplied);
    std::size_t pixel = 0;
    for (int row = 0; row < overlay.height(); ++row) {
        auto* pixels = reinterpret_cast<QRgb*>(overlay.scanLine(row));
        for (int column = 0; column < overlay.width(); ++column, ++pixel) {
            const QRgb opaque = colours[image.grey[pixel]];
            pixels[column] =
                image.opacity.empty() ? opaque : coloured(qAlpha(opaque) * (image.opacity[pixel] / white) / kMaxAlpha);
        }
    }
    return overlay;
}

/// The integral of an image's density over an outline, m²; 0 without an image.
double weightOf(const GreyImage* image, DenseWhere dense, const Polygon& outline) {
    if (!image) return 0.0;
    const Result<DensityArea> area = DensityArea::of(outline, *image, dense);
    return area ? area->weight() : 0.0;
}

/// Changes a count to a number of seeds in an area (m²); a density or a size stays if there are none.
void setNumber(SeedCount& count, double number, double area) {
    if (count.by == CountBy::Number) {
        count.amount = std::min(std::round(number), static_cast<double>(kMaxSeeds));
    } else if (number > 0.0) {
        count.amount = count.by == CountBy::Density ? number / area : std::sqrt(area / number);
    }
}

}  // namespace

const PatternLayer* BrushTool::layer() const {
    const Asset* shown = m_state.planarAsset();
    if (!shown) return nullptr;
    const auto isDensity = [](const PatternLayer& each) {
        return each.isOn && std::holds_alternative<DensityImage>(each.parameters);
    };
    const auto& layers = shown->pattern.layers;
    const auto found = std::find_if(layers.rbegin(), layers.rend(), isDensity);
    return found == layers.rend() ? nullptr : &*found;
}

const Polygon& BrushTool::imageOutline() const {
    const PatternLayer* target = layer();
    return target && target->scatteredIn ? *target->scatteredIn : m_state.planarAsset()->prism().outline;
}

/// That of the layer as it is painted; of a layer without a picture, some times that of the pieces.
double BrushTool::seedsPerArea(const PatternLayer* target) const {
    const Polygon& outline = imageOutline();
    const double whole = area(outline);
    if (target) {
        const auto& density = std::get<DensityImage>(target->parameters);
        const double weight = weightOf(density.image.get(), density.dense, outline), count = density.count.in(whole);
        if (weight > 0.0 && count > 0.0) return count / weight;
    }
    const double pieces = m_state.pattern ? m_state.pattern->partition().pieceCount() : 0.0;
    return kDenserThanPieces * std::max(pieces, kFewestPieces) / whole;
}

void BrushTool::press(const CanvasPointer& pointer) {
    if (!m_state.planarAsset()) return;
    m_pointer = pointer;
    const PatternLayer* target = layer();
    m_painting = Painting{.before = *m_state.asset(),
                          .last = pointer.metres,
                          .seedsPerArea = seedsPerArea(target),
                          .mergeKey = m_state.document.newMergeKey()};
    if (target) {
        m_painting->layer = target->id;
        m_painting->picture = std::get<DensityImage>(target->parameters).image;
    } else {
        m_painting->newId = m_painting->layer = m_state.document.project().nextId;
    }
    paintTo(pointer);
}

void BrushTool::paintTo(const CanvasPointer& pointer) {
    const Box2 box = boundsOf(imageOutline().outer);
    const PatternLayer* target = layer();
    const DenseWhere dense = target ? std::get<DensityImage>(target->parameters).dense : DenseWhere::Dark;
    const bool isErasing = m_isErasing != pointer.modifiers.testFlag(Qt::ShiftModifier);
    const Brush brush{radiusPixels() / m_state.view.scale, m_strength, valueOf(dense, isErasing)};
    GreyImage picture = m_painting->picture ? *m_painting->picture : uniformImage(box, valueOf(dense, true));
    picture = painted(std::move(picture), box, m_painting->last, pointer.metres, brush);
    m_painting->last = pointer.metres;
    push(std::make_shared<const GreyImage>(std::move(picture)));
}

void BrushTool::push(std::shared_ptr<const GreyImage> picture) {
    m_painting->picture = picture;
    Asset asset = m_painting->before;
    Pattern& pattern = m_state.patternIn(asset);
    Edit edit{.text = tr("Paint Density"), .mergeKey = m_painting->mergeKey};
    if (m_painting->newId != 0) {
        const bool exists = findLayer(m_state.planarAsset()->pattern, m_painting->newId) != nullptr;
        const Id id = exists ? m_painting->newId : edit.allocateId(m_state.document.project());
        m_painting->newId = m_painting->layer = id;
        pattern.layers.push_back({.id = id, .randomSeed = id, .parameters = DensityImage{}});
    }
    if (PatternLayer* target = findLayer(pattern, m_painting->layer)) {
        auto& density = std::get<DensityImage>(target->parameters);
        const Polygon& outline = imageOutline();
        const double weight = weightOf(picture.get(), density.dense, outline);
        setNumber(density.count, m_painting->seedsPerArea * weight, area(outline));
        density.image = std::move(picture);
        edit.replacements.push_back(Replacement<Asset>{asset.id, std::move(asset)});
        m_state.push(std::move(edit));
    }
    emit changed();
}

void BrushTool::move(const CanvasPointer& pointer) {
    m_pointer = pointer;
    if (m_painting && pointer.metres != m_painting->last) paintTo(pointer);
    emit changed();
}

void BrushTool::release(const CanvasPointer&) {
    m_painting.reset();
    emit changed();
}

void BrushTool::setRadiusPixels(double radius) {
    m_size.setRadiusPixels(radius);
    emit changed();
}

void BrushTool::stepSize(double steps) {
    m_size.step(steps);
    emit changed();
}

void BrushTool::setStrength(double strength) {
    m_strength = std::clamp(strength, kStrengthStep, 1.0);
    emit changed();
}

bool BrushTool::key(const QKeyEvent& event) {
    switch (event.key()) {
        case Qt::Key_BracketLeft: stepSize(-1.0); return true;
        case Qt::Key_BracketRight: stepSize(1.0); return true;
        case Qt::Key_Comma: setStrength(m_strength - kStrengthStep); return true;
        case Qt::Key_Period: setStrength(m_strength + kStrengthStep); return true;
        case Qt::Key_X:
            m_isErasing = !m_isErasing;
            emit changed();
            return true;
        default: return CanvasTool::key(event);
    }
}

bool BrushTool::controlWheel(double notches) {
    stepSize(notches);
    return true;
}

/// Elsewhere brackets select parents and children.
bool BrushTool::overridesShortcut(int key) const {
    constexpr std::array kOwn{Qt::Key_BracketLeft, Qt::Key_BracketRight, Qt::Key_Comma, Qt::Key_Period, Qt::Key_X};
    return std::ranges::find(kOwn, key) != kOwn.end();
}

bool BrushTool::cancel() {
    if (!m_painting) return false;
    const Painting painting = *std::exchange(m_painting, std::nullopt);
    if (m_state.asset() && m_state.asset()->id == painting.before.id) {
        m_state.push(modify(tr("Paint Density"), painting.before, painting.mergeKey));
    }
    emit changed();
    return true;
}

void BrushTool::endDrag() {
    m_painting.reset();
    emit changed();
}

void BrushTool::leave() {
    m_pointer.reset();
    emit changed();
}

void BrushTool::paintPicture(QPainter& painter, const CanvasColours& colours) const {
    const PatternLayer* target = layer();
    const auto* density = target ? &std::get<DensityImage>(target->parameters) : nullptr;
    if (!density || !density->image) return;
    if (density->image != m_overlay.image || density->dense != m_overlay.dense || colours.fault != m_overlay.colour) {
        m_overlay = {density->image, density->dense, colours.fault,
                     overlayOf(*density->image, density->dense, colours.fault)};
    }
    const Box2 box = boundsOf(imageOutline().outer);
    const QRectF area(m_state.view.pixels({box.min.x, box.max.y}), m_state.view.pixels({box.max.x, box.min.y}));
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(area, m_overlay.picture);
}

void BrushTool::paint(QPainter& painter, const CanvasColours& colours) const {
    if (!m_state.planarAsset()) return;
    paintPicture(painter, colours);
    if (!m_pointer) return;
    const bool isErasing = m_isErasing != m_pointer->modifiers.testFlag(Qt::ShiftModifier);
    for (const double part : {1.0, 0.5}) {
        paintBrushRing(painter, m_pointer->pixels, part * radiusPixels(), isErasing ? colours.text : colours.fault,
                       colours.halo, isErasing);
    }
}

QString BrushTool::hint() const {
    const QString action = m_isErasing ? tr("Drag: erase") : tr("Drag: paint the density of seeds");
    return tr("%1 · Shift: invert · X: switch between paint and erase · [ ], Ctrl and wheel: size · "
              ", .: strength %2 %")
        .arg(action)
        .arg(std::lround(100.0 * m_strength));
}

void BrushTool::fillMenu(QMenu& menu, const CanvasPointer&) {
    menu.addAction(tr("Increase Brush &Size"), this, [this] { stepSize(1.0); });
    menu.addAction(tr("&Decrease Brush Size"), this, [this] { stepSize(-1.0); });
    menu.addSeparator();
    menu.addAction(tr("Increase S&trength"), this, [this] { setStrength(m_strength + kStrengthStep); });
    menu.addAction(tr("Decrease Stren&gth"), this, [this] { setStrength(m_strength - kStrengthStep); });
    menu.addSeparator();
    QAction* erase = menu.addAction(tr("&Erase"), this, [this](bool isOn) {
        m_isErasing = isOn;
        emit changed();
    });
    erase->setCheckable(true);
    erase->setChecked(m_isErasing);
}

}  // namespace rubble

#include "moc_BrushTool.cpp"
