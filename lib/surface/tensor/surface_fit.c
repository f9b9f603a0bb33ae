/* lib/surface/tensor/surface_fit.c
 * SPDX-License-Identifier: MIT
 *
 * With A and B the values of the B-splines at u and v, D the fits of rows, and A' and B' without
 * the columns of kept control points, (P - D B^T) B' = 0 and A'^T (D - A C) = 0. Hence
 *
 *     A'^T (P - A C B^T) B' = A'^T (P - D B^T) B' + A'^T (D - A C) B^T B' = 0
 *
 * the condition for the smallest sum of squares in the inner control points.
 */
#include "surface/tensor/surface_fit.h"

enum loft_status loft_surface_fit(const loft_fit_grid *data, const loft_fit_net *net,
                                  loft_vec out[], loft_vec middle[], loft_sci memory[])
{
    const unsigned across = net->points_v;
    loft_vec *const column = middle + (size_t)data->rows * across, *const fitted = column +
                                                                                   data->rows;

    for (unsigned i = 0; i < data->rows; i++) {
        const loft_fit_points row = { data->p + (size_t)i * data->columns, data->v, NULL,
                                      data->columns };
        const enum loft_status status = loft_bspline_fit(
            &row, net->kv, across, net->degree_v, false, middle + (size_t)i * across, memory);
        if (status != LOFT_OK)
            return status;
    }
    for (unsigned j = 0; j < across; j++) {
        const loft_fit_points points = { column, data->u, NULL, data->rows };
        for (unsigned i = 0; i < data->rows; i++)
            column[i] = middle[(size_t)i * across + j];
        const enum loft_status status = loft_bspline_fit(&points, net->ku, net->points_u,
                                                         net->degree_u, false, fitted, memory);
        if (status != LOFT_OK)
            return status;
        for (unsigned i = 0; i < net->points_u; i++)
            out[(size_t)i * across + j] = fitted[i];
    }
    return LOFT_OK;
}
