#include "editor/widgets/input/HeldKey.h"

#include <QGuiApplication>
#include <QKeyEvent>

#if QT_CONFIG(xcb)
#include <xcb/xproto.h>

#include <cstdlib>
#include <memory>
#endif

namespace rubble {

bool isHeld(const QKeyEvent& event) {
#if QT_CONFIG(xcb)
    const auto* x11 = qGuiApp->nativeInterface<QNativeInterface::QX11Application>();
    const quint32 key = event.nativeScanCode();
    if (x11 == nullptr || key == 0) return false;
    xcb_connection_t* connection = x11->connection();
    const xcb_query_keymap_cookie_t request = xcb_query_keymap(connection);
    const std::unique_ptr<xcb_query_keymap_reply_t, decltype(&std::free)> reply(
        xcb_query_keymap_reply(connection, request, nullptr), &std::free);
    return reply && key / 8 < sizeof reply->keys && (reply->keys[key / 8] >> key % 8 & 1) != 0;
#else
    Q_UNUSED(event)
    return false;
#endif
}

}  // namespace rubble
