/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "cyclicFvPatch.H"
#include "fvMesh.H"
#include "processorFvPatch.H"
#include "UIPstream.H"
#include "UOPstream.H"
#include "volFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
Foam::label Foam::dew::cellDiffusion::send
(
    const Field<Type>& phi,
    messages<Type>& values
) const
{
    const label first = Pstream::nRequests();

    forAll(patchG_, patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        if (!isA<processorFvPatch>(patch) || !patch.size())
        {
            continue;
        }
        const processorFvPatch& between =
            refCast<const processorFvPatch>(patch);

        Field<Type>& in = values.in[patchi];
        in.setSize(patch.size());
        UIPstream::read
        (
            Pstream::commsTypes::nonBlocking,
            between.neighbProcNo(),
            reinterpret_cast<char*>(in.data()), in.byteSize(),
            between.tag(), between.comm()
        );

        Field<Type>& out = values.out[patchi];
        out.setSize(patch.size());
        forAll(out, facei)
        {
            out[facei] = phi[patch.faceCells()[facei]];
        }
        UOPstream::write
        (
            Pstream::commsTypes::nonBlocking,
            between.neighbProcNo(),
            reinterpret_cast<const char*>(out.cdata()), out.byteSize(),
            between.tag(), between.comm()
        );
    }

    return first;
}


template<class Type>
void Foam::dew::cellDiffusion::receive
(
    const Field<Type>& phi,
    const label request,
    const messages<Type>& values,
    Field<Type>& sum
) const
{
    Pstream::waitRequests(request);

    forAll(patchG_, patchi)
    {
        const scalarField& g = patchG_[patchi];
        const fvPatch& patch = mesh_.boundary()[patchi];
        const labelUList& cells = patch.faceCells();

        if (isA<processorFvPatch>(patch))
        {
            const Field<Type>& in = values.in[patchi];
            forAll(g, facei)
            {
                const label celli = cells[facei];
                sum[celli] += g[facei]*(in[facei] - phi[celli]);
            }
        }
        else if (g.size())
        {
            const labelUList& others =
                refCast<const cyclicFvPatch>(patch).neighbFvPatch()
               .faceCells();
            forAll(g, facei)
            {
                const label celli = cells[facei];
                sum[celli] += g[facei]*(phi[others[facei]] - phi[celli]);
            }
        }
    }
}


template<class Type>
void Foam::dew::cellDiffusion::step
(
    const Field<Type>& phi,
    Field<Type>& result,
    messages<Type>& values
) const
{
    const label request = send(phi, values);

    const labelUList& owner = mesh_.owner();
    const labelUList& neighbour = mesh_.neighbour();

    result = Zero;
    forAll(g_, facei)
    {
        const label a = owner[facei], b = neighbour[facei];
        const Type flux(g_[facei]*(phi[b] - phi[a]));
        result[a] += flux;
        result[b] -= flux;
    }
    receive(phi, request, values, result);

    forAll(result, celli)
    {
        result[celli] = phi[celli] + weight_[celli]*result[celli];
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
void Foam::dew::cellDiffusion::chebyshev
(
    const UList<scalar>& series,
    Field<Type>& phi
) const
{
    messages<Type> values;
    values.in.setSize(patchG_.size());
    values.out.setSize(patchG_.size());

    // T_k-1, T_k and T_k+1 of what came
    Field<Type> before(phi), present(phi.size()), next(phi.size());
    step(before, present, values);

    phi *= series[0];
    for (label k = 1; k < series.size(); k++)
    {
        forAll(phi, celli)
        {
            phi[celli] += series[k]*present[celli];
        }
        if (k + 1 < series.size())
        {
            step(present, next, values);
            forAll(next, celli)
            {
                next[celli] = 2*next[celli] - before[celli];
            }
            before.swap(present);
            present.swap(next);
        }
    }
}
