// SPDX-License-Identifier: GPL-3.0-or-later
// Radii by element for atoms that the chosen set does not have.
#include "core/radii/fallback_radii.hpp"

#include <cmath>

#include "core/molecule/element_table.hpp"

namespace alphascope {
namespace {

constexpr ElementEntry kBondiEntries[] = {
    {1, 1200},  {2, 1400},  {3, 1820},  {6, 1700},  {7, 1550},  {8, 1520},  {9, 1470},  {10, 1540},
    {11, 2270}, {12, 1730}, {14, 2100}, {15, 1800}, {16, 1800}, {17, 1750}, {18, 1880}, {19, 2750},
    {28, 1630}, {29, 1400}, {30, 1390}, {31, 1870}, {33, 1850}, {34, 1900}, {35, 1850}, {36, 2020},
    {46, 1630}, {47, 1720}, {48, 1580}, {49, 1930}, {50, 2170}, {52, 2060}, {53, 1980}, {54, 2160},
    {78, 1750}, {79, 1660}, {80, 1550}, {81, 1960}, {82, 2020}, {92, 1860}};
constexpr ElementTable kBondi = make_element_table(kBondiEntries);

// M. Mantina et al., J. Phys. Chem. A 113 (2009) 5806. These are main-group elements that Bondi
// left out, on Bondi's scale by construction.
constexpr ElementEntry kMantinaEntries[] = {
    {4, 1530},  {5, 1920},  {13, 1840}, {20, 2310}, {32, 2110}, {37, 3030}, {38, 2490}, {51, 2060},
    {55, 3430}, {56, 2680}, {83, 2070}, {84, 1970}, {85, 2020}, {86, 2200}, {87, 3480}, {88, 2830}};
constexpr ElementTable kMantina = make_element_table(kMantinaEntries);

// R. D. Shannon, Acta Cryst. A 32 (1976) 751: effective ionic radii with six neighbours. The first
// half has the charges that ChimeraX takes (the CRC Handbook's short table). These are Fe2+ and
// Co2+ of low spin, Mn2+ of high spin, else the commonest. The second half has elements that the
// table lacks: Ag+, Tl+; W, Re and Os 4+; else 3+.
constexpr ElementEntry kIonicEntries[] = {
    {3, 760},   {4, 450},   {9, 1330},  {11, 1020}, {12, 720},  {13, 540},  {17, 1810}, {19, 1380},
    {20, 1000}, {21, 750},  {22, 860},  {23, 790},  {24, 730},  {25, 830},  {26, 610},  {27, 650},
    {28, 690},  {29, 730},  {30, 740},  {31, 620},  {35, 1960}, {37, 1520}, {38, 1180}, {40, 720},
    {42, 690},  {43, 650},  {46, 860},  {48, 950},  {50, 690},  {53, 2200}, {55, 1670}, {56, 1350},
    {78, 800},  {79, 1370}, {80, 1020}, {82, 1190}, {83, 1030},

    {39, 900},  {44, 680},  {45, 665},  {47, 1150}, {49, 800},  {57, 1032}, {58, 1010}, {59, 990},
    {60, 983},  {62, 958},  {63, 947},  {64, 938},  {65, 923},  {66, 912},  {67, 901},  {68, 890},
    {69, 880},  {70, 868},  {71, 861},  {74, 660},  {75, 630},  {76, 630},  {77, 680},  {81, 1500}};
constexpr ElementTable kIonic = make_element_table(kIonicEntries);

// The usual value of crystallographic programs for elements without a van der Waals radius.
constexpr int kOtherMilliangstrom = 2000;

bool is_van_der_waals(RadiiSet set) {
  return set == RadiiSet::bondi || set == RadiiSet::alvarez;
}

AssignedRadius from(int milliangstrom, std::string_view source) {
  return {milliangstrom * 1000, true, source};
}

}  // namespace

int bondi_milliangstrom(Element element) {
  return element <= kHeaviestElement ? kBondi[element] : 0;
}

AssignedRadius fallback_radius(RadiiSet set, Element element, ResidueKind kind) {
  if (element == kUnknownElement || element > kHeaviestElement) {
    return from(static_cast<int>(std::lround(kUnknownRadiusAngstrom * 1000)),
                "of an unknown element");
  }
  const bool ion = is_metal(element) || (kind == ResidueKind::ion && is_halogen(element));
  if (ion && !is_van_der_waals(set) && kIonic[element] > 0) {
    return from(kIonic[element], "ionic radius, Shannon 1976");
  }
  if (kBondi[element] > 0) return from(kBondi[element], "Bondi 1964");
  if (kMantina[element] > 0) return from(kMantina[element], "Mantina 2009");
  return from(kOtherMilliangstrom, "no van der Waals radius known");
}

}  // namespace alphascope
