// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/file_drop.h"

#include <QApplication>
#include <QDropEvent>
#include <QMimeData>
#include <QTimer>
#include <QUrl>
#include <QWidget>

namespace drillwave {
namespace {

QStringList localFiles(const QMimeData* data) {
    QStringList paths;
    for (const QUrl& url : data->urls())
        if (url.isLocalFile()) paths.append(url.toLocalFile());
    return paths;
}

}  // namespace

FileDrop::FileDrop(QWidget* window) : QObject(window), m_window(window) {
    window->setAcceptDrops(true);
    qApp->installEventFilter(this);
}

bool FileDrop::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::DragEnter:
        case QEvent::DragMove:
        case QEvent::Drop:
            break;
        default:
            return false;
    }
    const bool isOurs = watched->isWidgetType() && static_cast<QWidget*>(watched)->window() == m_window;
    return isOurs && take(static_cast<QDropEvent&>(*event));
}

bool FileDrop::take(QDropEvent& event) {
    const QStringList paths = localFiles(event.mimeData());
    if (paths.isEmpty()) return false;
    event.setDropAction(Qt::CopyAction);
    event.accept();
    if (event.type() == QEvent::Drop) QTimer::singleShot(0, this, [this, paths] { emit dropped(paths); });
    return true;
}

}  // namespace drillwave
