/* host-tools/svg/svg_layer.c -- layers of Inkscape: which are asked for, and which are drawn
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include <string.h>

#include "base/scan.h"       /* scan_space */
#include "base/memory.h"
#include "read/machine_tools.h"
#include "svg/svg.h"

static const xmlChar inkscape_namespace[] = "http://www.inkscape.org/namespaces/inkscape";

/* The name of a layer of Inkscape, or NULL; free with xmlFree. */
static char *layer_name(const xmlNode *node)
{
    xmlChar *mode = svg_is(node, "g")
                        ? xmlGetNsProp(node, (const xmlChar *)"groupmode", inkscape_namespace)
                        : NULL;
    char *name    = NULL;

    if (mode != NULL && strcmp((const char *)mode, "layer") == 0) {
        name = (char *)xmlGetNsProp(node, (const xmlChar *)"label", inkscape_namespace);
        name = name ? name : svg_attribute(node, "id");
    }
    xmlFree(mode);
    return name;
}

/* Is it the name, or the number that the name begins with? AxiDraw numbers layers so. */
static bool is_layer(const char *name, const char *word, size_t length)
{
    const size_t digits = strspn(word, "0123456789");

    if (strncmp(name, word, length) != 0)
        return false;
    return name[length] == '\0' ||
           (length > 0 && digits >= length && strspn(name + length, "0123456789") == 0);
}

/* Does a list of names and numbers, with commas, name the layer? */
static bool is_listed(const char *list, const char *name)
{
    for (const char *word = list;;) {
        const size_t length = strcspn(word, ",");
        if (length > 0 && is_layer(name, word, length))
            return true;
        if (word[length] == '\0')
            return false;
        word += length + 1;
    }
}

bool svg_layer_chosen(const svg_reader *r, const xmlNode *node)
{
    char *name        = r->d->layers ? layer_name(node) : NULL;
    const bool chosen = name != NULL && is_listed(r->d->layers, name);

    xmlFree(name);
    return chosen;
}

unsigned svg_layer_tool(const svg_reader *r, const xmlNode *node)
{
    char *name     = r->d->tools ? layer_name(node) : NULL;
    unsigned found = r->layer_tool;

    for (unsigned i = name ? r->d->tools->count : 0; i-- > 0;)
        if (is_listed(r->d->tools->tool[i].layers, name))
            found = i + 1;
    xmlFree(name);
    return found;
}

static void keep_name(drawing_names *all, const char *name)
{
    const size_t size = strlen(name) + 1;

    all->name = memory_grow(all->name, (all->count + 1) * sizeof *all->name);
    all->name[all->count++] = memcpy(memory_grow(NULL, size), name, size);
}

unsigned svg_layer_number(svg_reader *r, const xmlNode *node)
{
    char *name           = r->boxing ? NULL : layer_name(node);
    const unsigned found = name != NULL ? ++r->layers : r->layer;

    if (name != NULL && r->d->named != NULL)
        keep_name(r->d->named, name);
    xmlFree(name);
    return found;
}

/* Look for a layer in the file; its names are added to `names`. */
static bool has_layer(const xmlNode *node, const char *word, size_t length, char names[200])
{
    bool found = false;

    for (; node != NULL && !found; node = node->next) {
        char *name        = layer_name(node);
        const size_t used = strlen(names);
        if (name != NULL)
            snprintf(names + used, 200 - used, "%s\"%.40s\"", used ? ", " : "", name);
        found = (name != NULL && is_layer(name, word, length)) ||
                has_layer(node->children, word, length, names);
        xmlFree(name);
    }
    return found;
}

bool svg_layers_check(const svg_reader *r, const xmlNode *root)
{
    for (const char *word = r->d->layers; word != NULL;) {
        const size_t length = strcspn(word, ",");
        char names[200]     = "";
        if (!has_layer(root->children, word, length, names))
            return svg_fail(r, "svg.no-layer", "no layer \"%.*s\": %s%s",
                            (int)(length < 60 ? length : 60), word,
                            *names ? "give one of "
                                   : "it has no layers of Inkscape: leave --layer "
                                     "out",
                            names);
        word = word[length] == '\0' ? NULL : word + length + 1;
    }
    return true;
}

bool svg_layer_drawn(svg_reader *r, const xmlNode *node)
{
    char *name       = layer_name(node);
    const char *at   = name;
    const bool named = name != NULL;

    if (named)
        scan_space(&at);
    const bool drawn = !named || *at != '%';
    if (!drawn)
        svg_warn(r, SVG_WARN_LAYER,
                 "layer \"%.40s\" is not drawn, as AxiDraw does: name it without %% to draw it",
                 name);
    else if (named && (*at == '!' || strstr(at, "+S") || strstr(at, "+H") || strstr(at, "+D")))
        svg_warn(r, SVG_WARN_LAYER_NUMBERS,
                 "layer \"%.40s\" has no speed, height, delay or pause of its own: "
                 "give it a tool with these, in the machine file",
                 name);
    xmlFree(name);
    return drawn;
}
