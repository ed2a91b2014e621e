#include "core/molecule/radii_set.hpp"

#include <array>

namespace alphascope {
namespace {

using ElementTable = std::array<std::int16_t, kHeaviestElement + 1>;  // 10^-3 Å; 0 = no value

struct Entry {
  Element element;
  std::int16_t milliangstrom;
};

template <std::size_t N>
constexpr ElementTable make_table(const Entry (&entries)[N]) {
  ElementTable table{};
  for (const Entry& e : entries) table[e.element] = e.milliangstrom;
  return table;
}

constexpr Entry kBondiEntries[] = {
    {1, 1200},  {2, 1400},  {3, 1820},  {6, 1700},  {7, 1550},  {8, 1520},  {9, 1470},  {10, 1540},
    {11, 2270}, {12, 1730}, {14, 2100}, {15, 1800}, {16, 1800}, {17, 1750}, {18, 1880}, {19, 2750},
    {28, 1630}, {29, 1400}, {30, 1390}, {31, 1870}, {33, 1850}, {34, 1900}, {35, 1850}, {36, 2020},
    {46, 1630}, {47, 1720}, {48, 1580}, {49, 1930}, {50, 2170}, {52, 2060}, {53, 1980}, {54, 2160},
    {78, 1750}, {79, 1660}, {80, 1550}, {81, 1960}, {82, 2020}, {92, 1860}};
constexpr ElementTable kBondi = make_table(kBondiEntries);

// Covers nearly every element, so it also fills the gaps of the other sets.
constexpr Entry kAlvarezEntries[] = {
    {1, 1200},  {2, 1430},  {3, 2120},  {4, 1980},  {5, 1910},  {6, 1770},  {7, 1660},  {8, 1500},
    {9, 1460},  {10, 1580}, {11, 2500}, {12, 2510}, {13, 2250}, {14, 2190}, {15, 1900}, {16, 1890},
    {17, 1820}, {18, 1830}, {19, 2730}, {20, 2620}, {21, 2580}, {22, 2460}, {23, 2420}, {24, 2450},
    {25, 2450}, {26, 2440}, {27, 2400}, {28, 2400}, {29, 2380}, {30, 2390}, {31, 2320}, {32, 2290},
    {33, 1880}, {34, 1820}, {35, 1860}, {36, 2250}, {37, 3210}, {38, 2840}, {39, 2750}, {40, 2520},
    {41, 2560}, {42, 2450}, {43, 2440}, {44, 2460}, {45, 2440}, {46, 2150}, {47, 2530}, {48, 2490},
    {49, 2430}, {50, 2420}, {51, 2470}, {52, 1990}, {53, 2040}, {54, 2060}, {55, 3480}, {56, 3030},
    {57, 2980}, {58, 2880}, {59, 2920}, {60, 2950}, {62, 2900}, {63, 2870}, {64, 2830}, {65, 2790},
    {66, 2870}, {67, 2810}, {68, 2830}, {69, 2790}, {70, 2800}, {71, 2740}, {72, 2630}, {73, 2530},
    {74, 2570}, {75, 2490}, {76, 2480}, {77, 2410}, {78, 2290}, {79, 2320}, {80, 2450}, {81, 2470},
    {82, 2600}, {83, 2540}, {89, 2800}, {90, 2930}, {91, 2880}, {92, 2710}, {93, 2820}, {94, 2810},
    {95, 2830}, {96, 3050}, {97, 3400}, {98, 3050}, {99, 2700}};
constexpr ElementTable kAlvarez = make_table(kAlvarezEntries);

constexpr RadiiSetInfo kAutomaticInfo{"auto", "automatic", ""};
constexpr RadiiSetInfo kFileInfo{"file", "from the file", "the radii written in the file itself"};
constexpr RadiiSetInfo kBondiInfo{
    "bondi", "Bondi",
    "A. Bondi, van der Waals volumes and radii, J. Phys. Chem. 68 (1964) 441-451"};

}  // namespace

const RadiiSetInfo& radii_set_info(RadiiSet set) {
  switch (set) {
    case RadiiSet::automatic:
      return kAutomaticInfo;
    case RadiiSet::file:
      return kFileInfo;
    case RadiiSet::bondi:
      break;
  }
  return kBondiInfo;
}

AssignedRadius element_radius(RadiiSet, Element element) {
  if (element == kUnknownElement || element > kHeaviestElement) return {};
  if (kBondi[element] > 0) return {kBondi[element], false};
  if (kAlvarez[element] > 0) return {kAlvarez[element], true};
  return {};
}

}  // namespace alphascope
