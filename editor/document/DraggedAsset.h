#pragma once

#include "core/asset/Project.h"

#include <QMimeData>

namespace rubble {

/// What is dragged from one part of a window to another: an asset, by its id.
inline constexpr const char* kAssetMimeType = "application/x-rubble-asset";

inline QMimeData* mimeDataOf(Id asset) {
    auto* data = new QMimeData;
    data->setData(kAssetMimeType, QByteArray::number(asset));
    return data;
}
/// 0 where it is none.
inline Id draggedAsset(const QMimeData* data) { return data->data(kAssetMimeType).toUInt(); }

}  // namespace rubble
