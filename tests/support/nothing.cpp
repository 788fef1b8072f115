// SPDX-License-Identifier: GPL-3.0-or-later
// The whole of a program that is built for its precompiled header alone.
int main() {}
