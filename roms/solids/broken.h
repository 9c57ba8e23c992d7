/* broken.h — pyramids with one mistake each in their tables, and a correct one.
 *
 *            V5            name         fails
 *           ╱│╲╲           whole        none
 *          ╱ │ ╲ ╲         vertex       1  a vertex without edges
 *         V4─│──╲─V3       edge         2  a diagonal that no polygon has
 *        ╱   │   ╲╱        open         3  the base lacks a side
 *       V1───┴───V2        alone        4  a triangle that touches nothing
 *                          pointer      5  an edge that points to the wrong polygon
 *
 * Models:     tables as somebody might have typed them, in the order of object_rule.
 * Ownership:  static tables.
 * Errors:     a name that there is not: false.
 */
#ifndef ROMS_SOLIDS_BROKEN_H
#define ROMS_SOLIDS_BROKEN_H

#include "roms/solids/object.h"

/* The five mistakes, in the order of the rules, then "whole"; ends with NULL. */
extern const char *const broken_names[];
/* Fills the tables as they stand, mistakes and all. */
void object_broken(struct object *o, int number);

#endif
