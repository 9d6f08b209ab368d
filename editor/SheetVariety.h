#pragma once

#include "core/asset/Breeding.h"

#include <QTreeWidget>

namespace rubble {

/// What varies on a contact sheet: a row for each kind that scatters, and one for each number of each layer with the range that
/// it takes values from. Ticked rows vary.
class SheetVariety : public QTreeWidget {
    Q_OBJECT
public:
    explicit SheetVariety(QWidget* parent = nullptr);

    /// Shows the layers of an asset, nothing ticked but what was ticked before.
    void setAsset(const Asset& asset);
    std::vector<std::string> kinds() const;
    std::vector<VariedParameter> varied() const;

private:
    void addKinds();
    void addLayer(const PatternLayer& layer);
};

}  // namespace rubble
