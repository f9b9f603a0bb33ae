/* host-tools/svg_file.c -- the XML of an SVG file: safely read, its ids and style sheets found, lines for messages
 * SPDX-License-Identifier: MIT
 *
 * libxml2 reads it, without network, external entities or limits lifted.
 */
#include <libxml/parser.h>
#include <libxml/SAX2.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "svg.h"
#include "tool.h"       /* tool_error, tool_grow */

#define ENTITIES_MAX (16ul << 20)   /* bytes of text that entities may stand for, counting each time */
#define TAG_LINES    10000          /* of a tag with one attribute and much path data per line         */


// Messages
// --------

/* libxml2 tells on which line a tag ends; it starts there or on one of the lines above. */
unsigned svg_at_line(const svg_reader *r)
{
    const unsigned end = (unsigned)xmlGetLineNo(r->node);
    const char *prefix = r->node->ns && r->node->ns->prefix ? (const char *)r->node->ns->prefix : "";
    char tag[80];

    snprintf(tag, sizeof tag, "<%s%s%s", prefix, *prefix ? ":" : "", (const char *)r->node->name);
    for (size_t n = end; n >= 1 && n <= r->line_count && end - n < TAG_LINES; n--)
        if (memmem(r->line[n - 1], (size_t)(r->line[n] - r->line[n - 1]), tag, strlen(tag)) != NULL)
            return (unsigned)n;
    return end;
}

static void find_lines(svg_reader *r, const char *text, size_t size)
{
    size_t room = 0;

    for (const char *at = text, *end = text + size; at != NULL;) {
        if (r->line_count + 2 > room)
            r->line = tool_grow(r->line, (room = room ? 2 * room : 256) * sizeof *r->line);
        r->line[r->line_count++] = at;
        at = memchr(at, '\n', (size_t)(end - at));
        at = at ? at + 1 : NULL;
    }
    r->line[r->line_count] = text + size;
}

bool svg_fail(const svg_reader *r, const char *format, ...)
{
    char text[300];
    va_list values;

    va_start(values, format);
    vsnprintf(text, sizeof text, format, values);
    va_end(values);
    (void)tool_error(EX_DATAERR, "%s:%u: <%s>: %s", r->file, svg_at_line(r), (const char *)r->node->name, text);
    return false;
}

void svg_warn(svg_reader *r, unsigned kind, const char *format, ...)
{
    char text[300];
    va_list values;

    if (r->warned & 1u << kind)
        return;
    r->warned |= 1u << kind;
    va_start(values, format);
    vsnprintf(text, sizeof text, format, values);
    va_end(values);
    (void)tool_error(EX_OK, "%s:%u: %s", r->file, svg_at_line(r), text);
}


// Ids and style sheets
// --------------------

static const xmlChar svg_namespace[]   = "http://www.w3.org/2000/svg";

bool svg_is(const xmlNode *node, const char *name)
{
    return node->type == XML_ELEMENT_NODE && (node->ns == NULL || xmlStrEqual(node->ns->href, svg_namespace)) &&
           (name == NULL || strcmp((const char *)node->name, name) == 0);
}

/* The element that follows in the file, children first. */
static const xmlNode *following(const xmlNode *node)
{
    if (node->children != NULL && node->type == XML_ELEMENT_NODE)
        return node->children;
    while (node != NULL && node->next == NULL)
        node = node->parent;
    return node ? node->next : NULL;
}

typedef struct {
    svg_named named;
    size_t order;
} numbered;

static int by_id_and_order(const void *a, const void *b)
{
    const numbered *x = a, *y = b;
    const int order = strcmp(x->named.id, y->named.id);

    return order ? order : (x->order > y->order) - (x->order < y->order);
}

/* Collect ids and style sheets. */
static void survey(svg_reader *r, const xmlNode *root)
{
    numbered *list = NULL;
    size_t count = 0, room = 0;

    for (const xmlNode *node = root; node != NULL; node = following(node)) {
        char *id = node->type == XML_ELEMENT_NODE ? svg_attribute(node, "id") : NULL;
        if (id != NULL) {
            if (count == room)
                list = tool_grow(list, (room = room ? 2 * room : 64) * sizeof *list);
            list[count] = (numbered){ { id, node }, count };
            count++;
        }
        r->node = node;
        if (svg_is(node, "style"))
            svg_sheet_read(r, node);
    }
    if (count > 0)
        qsort(list, count, sizeof *list, by_id_and_order);
    r->named = tool_grow(NULL, count * sizeof *r->named);
    r->named_count = count;
    for (size_t i = 0; i < count; i++)
        r->named[i] = list[i].named;
    free(list);
}


// XML
// ---

/* What the XML reader reports while it reads. */
typedef struct {
    char message[200];          /* of the first error; those behind it are its consequences */
    int line;
    unsigned long expanded;     /* bytes of entities */
} report;

static void keep_first_error(void *context, xmlErrorPtr error)
{
    report *r = ((xmlParserCtxtPtr)context)->_private;

    if (r->message[0] != '\0' || error->level < XML_ERR_ERROR || error->domain == XML_FROM_NAMESPACE)
        return;
    snprintf(r->message, sizeof r->message, "%s", error->message ? error->message : "unknown");
    r->message[strcspn(r->message, "\n")] = '\0';
    r->line = error->line;
}

/* Entities are looked up here each time they are used: a small file cannot stand for gigabytes. */
static xmlEntityPtr find_entity(void *context, const xmlChar *name)
{
    xmlParserCtxtPtr parser = context;
    report *r = parser->_private;
    xmlEntityPtr entity = xmlSAX2GetEntity(context, name);

    r->expanded += entity ? (unsigned long)entity->length : 0;
    if (r->expanded <= ENTITIES_MAX)
        return entity;
    snprintf(r->message, sizeof r->message, "its entities stand for more than %lu MB", ENTITIES_MAX >> 20);
    r->line = parser->input ? parser->input->line : 0;
    xmlStopParser(parser);
    return NULL;
}

/* Nothing but the file itself is ever read. */
static xmlParserInputPtr load_nothing(const char *url, const char *id, xmlParserCtxtPtr context)
{
    (void)url, (void)id, (void)context;
    return NULL;
}

static xmlDocPtr parse(const char *text, size_t size, report *r)
{
    xmlParserCtxtPtr context = xmlNewParserCtxt();
    if (context == NULL)
        return NULL;

    xmlSetExternalEntityLoader(load_nothing);
    context->_private = r;
    context->sax->serror = keep_first_error;
    context->sax->getEntity = find_entity;
    xmlDocPtr document = xmlCtxtReadMemory(context, text, (int)size, NULL, NULL, XML_PARSE_NONET | XML_PARSE_NOENT |
                                           XML_PARSE_NOCDATA | XML_PARSE_BIG_LINES);
    xmlFreeParserCtxt(context);
    return document;
}

int drawing_read_svg(drawing *d, const char *file, const char *text, size_t size)
{
    svg_reader r = { .d = d, .file = file };
    report problem = { .message = "" };
    xmlDocPtr document = parse(text, size, &problem);
    const xmlNode *root = document ? xmlDocGetRootElement(document) : NULL;
    int code = 0;

    find_lines(&r, text, size);
    if (root == NULL)
        code = tool_error(EX_DATAERR, "%s:%d: broken XML: %s", file, problem.line, problem.message);
    else if (!svg_is(root, "svg"))
        code = tool_error(EX_DATAERR, "%s:%ld: <%s> is no SVG drawing: <svg xmlns=\"http://www.w3.org/2000/svg\"> is expected", file,
                          xmlGetLineNo(root), (const char *)root->name);
    else {
        survey(&r, root);
        code = svg_draw(&r, root) ? 0 : EX_DATAERR;
    }

    for (size_t i = 0; i < r.named_count; i++)
        xmlFree(r.named[i].id);
    free(r.named);
    free(r.line);
    svg_sheet_free(r.sheet);
    if (document != NULL)
        xmlFreeDoc(document);
    return code;
}
