#pragma once

#include "editor/dialogs/ProjectExport.h"

#include <QTreeWidget>

namespace rubble {

/// Shows the folders and files that an export writes. A disabled item in a folder stands for further files whose names
/// depend on the fragments.
class ExportTree : public QTreeWidget {
    Q_OBJECT
public:
    explicit ExportTree(QWidget* parent = nullptr);

    /// Folders stay expanded or collapsed.
    void setListing(const ExportListing& listing);
    QSize sizeHint() const override;
};

}  // namespace rubble
