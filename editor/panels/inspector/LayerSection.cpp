#include "editor/panels/inspector/LayerSection.h"

#include "editor/widgets/appearance/LayerText.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace rubble {

namespace {

constexpr double kFractionStep = 0.05;

/// The factor from SI units to the unit shown.
double shownPer(const LayerParameter& parameter) {
    return parameter.quantity == Quantity::Angle ? 180.0 / std::numbers::pi : 1.0;
}

FieldRange fieldRange(const LayerParameter& parameter) {
    const ParameterRange& range = parameter.range;
    const double factor = shownPer(parameter);
    FieldRange field{.min = range.min, .max = range.max, .isMinExcluded = range.isMinExcluded};
    if (factor != 1.0)
        field = {.min = std::round(range.min * factor), .max = std::round(range.max * factor), .step = 1.0};
    if (parameter.type == ParameterType::Whole) field = FieldRange::whole(range.min, range.max);
    if (range.min == 0.0 && range.max == 1.0 && !field.isWhole) field.step = kFractionStep;
    return field;
}

auto numberOf(const LayerParameter& parameter) {
    return [&parameter, factor = shownPer(parameter)](const PatternLayer& layer) {
        return std::get<double>(parameter.read(layer.parameters)) * factor;
    };
}

auto settingNumber(const LayerParameter& parameter) {
    return [&parameter, factor = shownPer(parameter)](PatternLayer& layer, double entered) {
        const double value = std::clamp(entered / factor, parameter.range.min, parameter.range.max);
        parameter.write(layer.parameters, value);
    };
}

SeedCount countOf(const LayerParameter& parameter, const PatternLayer& layer) {
    return std::get<SeedCount>(parameter.read(layer.parameters));
}

/// The same count expressed in another way, up to rounding.
SeedCount converted(const SeedCount& count, CountBy by, double size, SeedSpace space) {
    if (count.by == by) return count;
    const double number = std::clamp(count.in(size, space), 1.0, static_cast<double>(kMaxSeeds));
    const double each = size / number;
    switch (by) {
        case CountBy::Number: break;
        case CountBy::Density: return {by, number / size};
        case CountBy::FragmentSize: return {by, space == SeedSpace::Plane ? std::sqrt(each) : std::cbrt(each)};
    }
    return {by, number};
}

}  // namespace

LayerSection::LayerSection(const PatternKind& kind, Document& document, const LayerForm::Selected& selected,
                           const LayerForm::Push& push, QWidget* parent)
    : Section(parent), m_kind(kind), m_form(document, selected, push) {
    m_form.setRefused([this](const QString& sentence) { emit refused(sentence); });
    m_form.setFault(
        [](const PatternLayer& layer) { return QString::fromStdString(verifyPattern(Pattern{{layer}}).value_or("")); });
    for (const LayerParameter& parameter : kind.parameters) addParameter(parameter);
}

void LayerSection::addParameter(const LayerParameter& parameter) {
    const QString step = tr("Set %1").arg(inTitleCase(patternText(parameter.caption)));
    QWidget* row = nullptr;
    switch (parameter.type) {
        case ParameterType::Whole:
        case ParameterType::Real: row = addNumber(parameter, step); break;
        case ParameterType::Option: row = addOption(parameter, step); break;
        case ParameterType::Point: return addPoint(parameter, step);
        case ParameterType::Count: return addCount(parameter, step);
    }
    if (!parameter.usedIf && !parameter.isSpatial) return;
    m_rowUpdates.push_back([this, row, &parameter](const PatternLayer& layer) {
        setRowVisible(row, isShown(parameter, m_space) && parameter.isUsed(layer.parameters));
    });
}

template <class Control, class Read, class Write>
void LayerSection::bindNumber(Control* control, Quantity quantity, const QString& step, Read read, Write write) {
    m_form.bind(control, step, read, write);
    if (quantity == Quantity::Angle) control->setFormat(Units::angles());
    if (quantity == Quantity::Length) {
        m_unitSetters.push_back([control](const Units& units) { control->setFormat(units.lengths()); });
    }
}

QWidget* LayerSection::addNumber(const LayerParameter& parameter, const QString& step) {
    const QString caption = patternText(parameter.caption), hint = patternText(parameter.hint);
    const SliderRange& range = parameter.sliderRange;
    const double factor = shownPer(parameter);
    if (range.from == range.to) {
        auto* field = addRow(caption, new NumberField, hint);
        field->setRange(fieldRange(parameter));
        bindNumber(field, parameter.quantity, step, numberOf(parameter), settingNumber(parameter));
        return field;
    }
    const SliderScale scale = range.isLogarithmic ? SliderScale::Logarithmic : SliderScale::Linear;
    auto* slider =
        addRow(caption, new SliderField(fieldRange(parameter), range.from * factor, range.to * factor, scale), hint);
    bindNumber(slider, parameter.quantity, step, numberOf(parameter), settingNumber(parameter));
    return slider;
}

/// A box that selects how the count is expressed, and a row for each way, of which one is visible.
void LayerSection::addCount(const LayerParameter& parameter, const QString& step) {
    const QString caption = patternText(parameter.caption), hint = patternText(parameter.hint);
    auto* by = addRow(tr("%1 by").arg(caption), new QComboBox,
                      tr("Whether to enter the number of seeds, their density or the size of fragments"));
    by->addItem(tr("Number"), static_cast<Id>(CountBy::Number));
    by->addItem(tr("Seeds per m²"), static_cast<Id>(CountBy::Density));
    by->addItem(tr("Fragment Size"), static_cast<Id>(CountBy::FragmentSize));
    m_form.bind(
        by, step, [&parameter](const PatternLayer& layer) { return static_cast<Id>(countOf(parameter, layer).by); },
        [this, &parameter](PatternLayer& layer, Id entered) {
            const auto wanted = static_cast<CountBy>(entered);
            parameter.write(layer.parameters, converted(countOf(parameter, layer), wanted, m_size, m_space));
        });
    m_rowUpdates.push_back([this, by](const PatternLayer&) {
        const bool isPlane = m_space == SeedSpace::Plane;
        by->setItemText(by->findData(static_cast<Id>(CountBy::Density)),
                        isPlane ? tr("Seeds per m²") : tr("Seeds per m³"));
    });
    const auto bound = [&](CountBy way, Quantity quantity, auto* control,
                           std::optional<SeedSpace> only = std::nullopt) {
        bindNumber(
            control, quantity, step,
            [this, &parameter, way](const PatternLayer& layer) {
                return converted(countOf(parameter, layer), way, m_size, m_space).amount;
            },
            [&parameter, way](PatternLayer& layer, double entered) {
                parameter.write(layer.parameters, SeedCount(way, entered));
            });
        m_rowUpdates.push_back([this, control, way, only, &parameter](const PatternLayer& layer) {
            setRowVisible(control, countOf(parameter, layer).by == way && only.value_or(m_space) == m_space);
        });
    };
    const FieldRange whole = FieldRange::whole(parameter.range.min, parameter.range.max);
    const SliderRange& range = parameter.sliderRange;
    if (range.from == range.to) {
        auto* number = addRow(caption, new NumberField, hint);
        number->setRange(whole);
        bound(CountBy::Number, Quantity::Number, number);
    } else {
        bound(CountBy::Number, Quantity::Number,
              addRow(caption, new SliderField(whole, range.from, range.to, SliderScale::Logarithmic), hint));
    }
    bound(CountBy::Density, Quantity::Number,
          addRow(tr("Seeds per m²"), new SliderField(FieldRange::aboveZero(), 0.1, 10'000.0, SliderScale::Logarithmic),
                 tr("Number of seeds per square metre of the outline")),
          SeedSpace::Plane);
    bound(CountBy::Density, Quantity::Number,
          addRow(tr("Seeds per m³"), new SliderField(FieldRange::aboveZero(), 0.1, 1e6, SliderScale::Logarithmic),
                 tr("Number of seeds per cubic metre of the mesh")),
          SeedSpace::Solid);
    bound(CountBy::FragmentSize, Quantity::Length,
          addRow(tr("Fragment size"), new SliderField(FieldRange::aboveZero(), 0.005, 2.0, SliderScale::Logarithmic),
                 tr("Side length of a square, or a cube in a mesh, of the size of the average fragment")));
}

QWidget* LayerSection::addOption(const LayerParameter& parameter, const QString& step) {
    auto* box = addRow(patternText(parameter.caption), new QComboBox, patternText(parameter.hint));
    for (std::size_t k = 0; k < parameter.options.size(); ++k) {
        box->addItem(patternText(parameter.options[k].caption), static_cast<Id>(k));
    }
    m_form.bind(
        box, step,
        [&parameter](const PatternLayer& layer) {
            return static_cast<Id>(std::get<double>(parameter.read(layer.parameters)));
        },
        [&parameter](PatternLayer& layer, Id entered) {
            parameter.write(layer.parameters, static_cast<double>(entered));
        });
    m_rowUpdates.push_back([this, box, &parameter](const PatternLayer&) {
        const auto text = [this](const char* plane, const char* solid) {
            return patternText(m_space == SeedSpace::Solid && solid != nullptr ? solid : plane);
        };
        box->setToolTip(text(parameter.hint, parameter.solidHint));
        for (std::size_t k = 0; k < parameter.options.size(); ++k) {
            const ParameterOption& option = parameter.options[k];
            box->setItemText(static_cast<int>(k), text(option.caption, option.solidCaption));
        }
    });
    return box;
}

void LayerSection::addPoint(const LayerParameter& parameter, const QString& step) {
    const QStringList axes{tr("x"), tr("y")};
    for (int axis = 0; axis < 2; ++axis) {
        auto* field = addRow(tr("%1 %2").arg(patternText(parameter.caption), axes[axis]), new NumberField,
                             patternText(parameter.hint));
        m_form.bind(
            field, step,
            [&parameter, axis](const PatternLayer& layer) {
                return std::get<Vec2>(parameter.read(layer.parameters))[axis];
            },
            [&parameter, axis](PatternLayer& layer, double entered) {
                Vec2 point = std::get<Vec2>(parameter.read(layer.parameters));
                point[axis] = entered;
                parameter.write(layer.parameters, point);
            });
        m_unitSetters.push_back([field](const Units& units) { field->setFormat(units.lengths()); });
    }
}

void LayerSection::setUnits(const Units& units) {
    for (const auto& take : m_unitSetters) take(units);
}

void LayerSection::refresh(const PatternLayer& layer, double size, SeedSpace space) {
    m_size = size;
    m_space = space;
    for (const auto& show : m_rowUpdates) show(layer);
    m_form.refresh();
}

}  // namespace rubble

#include "moc_LayerSection.cpp"
