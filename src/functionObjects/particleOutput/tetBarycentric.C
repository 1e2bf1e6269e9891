/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "tetBarycentric.H"
#include "polyMeshTetDecomposition.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::tetBarycentric::tetBarycentric(const polyMesh& mesh)
:
    mesh_(mesh),
    cell_(-1)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::passiveParticle Foam::dew::tetBarycentric::inCell
(
    const point& p,
    const label celli
)
{
    if (celli != cell_)
    {
        tets_ = polyMeshTetDecomposition::cellTetIndices(mesh_, celli);
        cell_ = celli;
    }

    barycentric best(Zero);
    scalar bestMin = -GREAT;
    label facei = -1, pti = -1;

    for (const tetIndices& tet : tets_)
    {
        const tetPointRef t(tet.tet(mesh_));

        // Six times the signed volumes opposite a, b, c and d
        const vector ab(t.b() - t.a()), ac(t.c() - t.a()), ad(t.d() - t.a());
        const vector ap(p - t.a());
        const scalar V = (ab ^ ac) & ad;
        const scalar b = (ap ^ ac) & ad;
        const scalar c = (ab ^ ap) & ad;
        const scalar d = (ab ^ ac) & ap;

        if (V == 0)
        {
            continue;
        }

        const barycentric lambda((V - b - c - d)/V, b/V, c/V, d/V);
        const scalar least = cmptMin(lambda);

        if (least > bestMin)
        {
            bestMin = least;
            best = lambda;
            facei = tet.face();
            pti = tet.tetPt();
        }
        if (least >= 0)
        {
            break;
        }
    }

    return passiveParticle(mesh_, best, celli, facei, pti);
}
