// SPDX-License-Identifier: GPL-3.0-or-later
// The whole of a program that is built only for its precompiled header.
int main() {}
