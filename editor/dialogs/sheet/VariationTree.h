#pragma once

#include "core/asset/bake/VariantGeneration.h"

#include <QTreeWidget>

namespace rubble {

/// The varied parameters of a contact sheet: a row with a range for each numeric parameter of each layer, and a row for
/// each kind of scattering layer. Checked rows vary.
class VariationTree : public QTreeWidget {
    Q_OBJECT
public:
    explicit VariationTree(QWidget* parent = nullptr);

    /// Shows the layers of an asset. Rows that are still there keep their checks and ranges.
    void setAsset(const Asset& asset);
    /// The names of the checked kinds.
    std::vector<std::string> kinds() const;
    /// The checked parameters.
    std::vector<VariedParameter> varied() const;

private:
    void addKinds();
    void addLayer(const PatternLayer& layer);
};

}  // namespace rubble
