#include "editor/dialogs/ExportTree.h"

#include "core/base/MessageText.h"
#include "editor/document/ShownText.h"
#include "editor/widgets/Icon.h"

#include <QDir>
#include <QHeaderView>

#include <map>

namespace rubble {

namespace {

constexpr int kMaxExpandedPacks = 4;  // of more, only the names of their folders are shown at first
constexpr int kRows = 8;
constexpr int kTreeWidth = 260;  // pixels, so that the names of most files fit

QString folderText(const QString& folder) {
    const QString path = QDir::cleanPath(folder);
    const QString name = fileNameText(path);
    return name.isEmpty() ? pathText(path) : name;
}

void addFile(QTreeWidgetItem& folder, const std::string& name) {
    auto* item = new QTreeWidgetItem(&folder, {QString::fromStdString(printableText(name))});
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren);
}

}  // namespace

ExportTree::ExportTree(QWidget* parent) : QTreeWidget(parent) {
    setAccessibleName(tr("Files to be written"));
    setHeaderHidden(true);
    setUniformRowHeights(true);
    setEditTriggers(NoEditTriggers);
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(QHeaderView::ResizeToContents);  // long names are scrolled to
}

QSize ExportTree::sizeHint() const {
    const int row = std::max(sizeHintForRow(0), fontMetrics().height());
    return {kTreeWidth, kRows * row + 2 * frameWidth()};
}

void ExportTree::setListing(const ExportListing& listing) {
    std::map<QString, bool> isExpanded;
    const QTreeWidgetItem* before = topLevelItem(0);
    for (int k = 0; before != nullptr && k < before->childCount(); ++k)
        isExpanded[before->child(k)->text(0)] = before->child(k)->isExpanded();
    clear();
    auto* root = new QTreeWidgetItem(this, {folderText(listing.folder)});
    root->setToolTip(0, toolTipText(pathText(QDir::toNativeSeparators(listing.folder))));
    root->setIcon(0, iconNamed("file-open"));
    root->setExpanded(true);
    for (const PackListing& pack : listing.packs) {
        auto* folder = new QTreeWidgetItem(root, {QString::fromStdString(printableText(pack.folder))});
        folder->setIcon(0, iconNamed("file-open"));
        for (const std::string& name : pack.files.names) addFile(*folder, name);
        if (!pack.files.areAll) {
            auto* more = new QTreeWidgetItem(folder, {tr("More meshes, depending on the fragments")});
            more->setFlags(Qt::ItemNeverHasChildren);
        }
        const auto known = isExpanded.find(folder->text(0));
        folder->setExpanded(known != isExpanded.end() ? known->second : listing.packs.size() <= kMaxExpandedPacks);
    }
    for (const std::string& name : listing.files) addFile(*root, name);
}

}  // namespace rubble

#include "moc_ExportTree.cpp"
