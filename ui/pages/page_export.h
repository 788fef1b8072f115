// SPDX-License-Identifier: GPL-3.0-or-later
// Something of a page that can be written to a file.
#pragma once

#include <QByteArray>
#include <QString>
#include <functional>
#include <optional>

#include "ui/questions/picture_dialog.h"

namespace drillwave {

/// Numbers or a picture. The functions give what the page shows when they are called.
struct PageExport {
    struct Picture {
        /// Returns the bytes of the file, empty when it cannot be drawn; `title` goes into its properties.
        std::function<QByteArray(const PictureChoice& choice, const QString& title)> file;
        std::function<double()> aspectRatio;  ///< width/height on screen
        std::function<void()> copy;           ///< to the clipboard
    };

    QString title;     ///< in the menu: "&Data of this plot…"
    QString toolTip;   ///< the same in a sentence
    QString fileStem;  ///< what the file's name adds to that of the scenario: "_plot", or nothing
    std::function<QByteArray()> csv;
    /// Whether csv() returns rows to be put after a header with the blow, or a whole file.
    enum class Content { rows, wholeFile } content = Content::rows;
    /// Why it cannot be written now; empty, or no function, when it can.
    std::function<QString()> obstacle = {};
    std::optional<Picture> picture;  ///< instead of csv
};

}  // namespace drillwave
