// SPDX-License-Identifier: GPL-3.0-or-later
// A file written whole or not at all, for people who see a window.
#pragma once

#include <QByteArray>
#include <QString>

namespace drillwave {

/// Writes the file as replaceFile() of the core does. Returns why not, in one line that begins with the path,
/// or with `name` if the path means nothing to people.
QString writeWholeFile(const QString& path, const QByteArray& bytes, const QString& name = {});

/// Writes the file in the same way; returns only the reason.
QString replaceFile(const QString& path, const QByteArray& bytes);

}  // namespace drillwave
