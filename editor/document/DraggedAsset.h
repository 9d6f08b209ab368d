#pragma once

#include "core/asset/project/Project.h"

#include <QMimeData>

namespace rubble {

/// The MIME type of an asset that is dragged and dropped within a window; the data is its id.
inline constexpr const char* kAssetMimeType = "application/x-rubble-asset";

inline QMimeData* mimeDataOf(Id asset) {
    auto* data = new QMimeData;
    data->setData(kAssetMimeType, QByteArray::number(asset));
    return data;
}
/// The dragged asset's id; 0 if the data is not an asset.
inline Id draggedAsset(const QMimeData* data) { return data->data(kAssetMimeType).toUInt(); }

}  // namespace rubble
